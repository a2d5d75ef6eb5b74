// How finely the picture is drawn: with all that graphics hardware gives, or plainly where the processor itself draws.

import * as THREE from 'three';

const kSoftware = /swiftshader|llvmpipe|softpipe|software|basic render/i; // renderers without hardware

// What WebGL draws with is only told by a context; this one is given back at once.
function drawsInSoftware() {
  const gl = document.createElement('canvas').getContext('webgl2');
  if (!gl) return false;
  const told = gl.getExtension('WEBGL_debug_renderer_info');
  const name = String(gl.getParameter(told ? told.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
  gl.getExtension('WEBGL_lose_context')?.loseContext();
  return kSoftware.test(name);
}

// #fine=1 in the address asks for everything, for pictures.
export const plain = !new URLSearchParams(location.hash.slice(1)).has('fine') && drawsInSoftware();

// options as of MeshStandardMaterial; what a plain material has not is left out.
export function surface(options) {
  if (!plain) return new THREE.MeshStandardMaterial(options);
  const { roughness, metalness, ...simple } = options;
  return new THREE.MeshLambertMaterial(simple);
}
