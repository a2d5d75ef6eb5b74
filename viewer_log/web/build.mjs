// Bundles src/ into dist/, or with --check tells whether dist/ is what a fresh build gives.
import { build } from 'esbuild';
import { mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync, mkdirSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
const dist = join(here, 'dist');
const largest = 1024 * 1024;

function licences() {
  const three = readFileSync(join(here, 'node_modules/three/LICENSE'), 'utf8');
  const uplot = readFileSync(join(here, 'node_modules/uplot/LICENSE'), 'utf8');
  const apache = readFileSync(join(here, 'licenses/Apache-2.0.txt'), 'utf8');
  return `app.js and app.css contain these libraries.\n\n` +
    `==== three (MIT) ====\n\n${three}\n` +
    `==== uPlot (MIT) ====\n\n${uplot}\n` +
    `==== urdf-loader (Apache License 2.0; copyright California Institute of Technology) ====\n\n${apache}`;
}

async function makeInto(folder) {
  mkdirSync(folder, { recursive: true });
  await build({
    absWorkingDir: here,
    entryPoints: ['src/main.js'],
    outfile: join(folder, 'app.js'),
    bundle: true,
    minify: true,
    format: 'esm',
    target: 'es2022',
    legalComments: 'none',
    logLevel: 'warning',
  });
  const page = readFileSync(join(here, 'src/index.html'), 'utf8');
  writeFileSync(join(folder, 'index.html'), page.split('\n').map((line) => line.trim()).filter(Boolean).join(' ') + '\n');
  writeFileSync(join(folder, 'LICENSES.txt'), licences());
}

if (process.argv.includes('--check')) {
  const fresh = mkdtempSync(join(tmpdir(), 'twinbus-web-'));
  try {
    await makeInto(fresh);
    const names = [...new Set([...readdirSync(fresh), ...readdirSync(dist)])];
    const differ = names.filter((name) => {
      try {
        return !readFileSync(join(fresh, name)).equals(readFileSync(join(dist, name)));
      } catch {
        return true;
      }
    });
    if (differ.length > 0) {
      console.error(`dist differs from a fresh build: ${differ.join(', ')}; run npm run build`);
      process.exitCode = 1;
    } else {
      console.log('dist is what a fresh build gives');
    }
  } finally {
    rmSync(fresh, { recursive: true });
  }
} else {
  rmSync(dist, { recursive: true, force: true });
  await makeInto(dist);
  const bytes = readdirSync(dist).reduce((n, name) => n + readFileSync(join(dist, name)).length, 0);
  console.log(`dist: ${Math.round(bytes / 1024)} kB`);
  if (bytes > largest) {
    console.error('dist is larger than 1 MB');
    process.exitCode = 1;
  }
}
