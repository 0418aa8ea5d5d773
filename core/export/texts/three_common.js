// Missing tangents are computed; those of three.js have the opposite sign where v points down.
function needTangents(geometry, vDown) {
  if (geometry.attributes.tangent) return;
  if (!geometry.index || !geometry.attributes.uv) {
    console.warn('@NAME@: the geometry needs tangents; BufferGeometryUtils computes them');
    return;
  }
  geometry.computeTangents();
  const {array} = geometry.attributes.tangent;
  if (vDown) for (let i = 3; i < array.length; i += 4) array[i] = -array[i];
}

function assign(uniform, value) {
  if (typeof uniform.value === 'number') uniform.value = value;
  else if (uniform.value.isColor && !Array.isArray(value)) uniform.value.set(value);
  else if (Array.isArray(value)) uniform.value.fromArray(value);
  else uniform.value.copy(value);
}

