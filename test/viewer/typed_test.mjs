// How the page writes the program's name.   node typed_test.mjs
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { kWritten, typed } from '../../viewer_log/web/src/typed.js';

assert.equal(typed('start the stack with ./twinbus up.', 'twinbus'), 'start the stack with twinbus up.');
assert.equal(typed('./twinbus up, then ./twinbus stop', 'twinbus'), 'twinbus up, then twinbus stop');
assert.equal(typed('./twinbus up', './twinbus'), './twinbus up', 'in the source tree nothing changes');
assert.equal(typed('./twinbus up'), './twinbus up', 'nor where nothing is known');
for (const path of ['../twinbus/runs', 'a/./twinbus', './twinbus_viewer', './twinbus/runs']) assert.equal(typed(path, 'twinbus'), path);

// The viewer writes its word over this one.
for (const page of ['src', 'dist']) {
  const html = readFileSync(new URL(`../../viewer_log/web/${page}/index.html`, import.meta.url), 'utf8');
  assert.equal(html.split(`<html lang="en" data-command="${kWritten}">`).length, 2, page);
}
console.log('ok');
