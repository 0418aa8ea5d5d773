function load({uniform, file, float, srgb, wrap, nearest}) {
  if (loaded.has(uniform)) return loaded.get(uniform);
  const entry = {};
  entry.ready = new Promise((resolve, reject) => {
    const loader = float ? new EXRLoader().setDataType(floatType()) : new THREE.TextureLoader();
    const set = (texture) => {
      texture.wrapS = texture.wrapT = wrap;
      texture.generateMipmaps = true;
      texture.minFilter = nearest ? THREE.NearestMipmapNearestFilter : THREE.LinearMipmapLinearFilter;
      texture.magFilter = nearest ? THREE.NearestFilter : THREE.LinearFilter;
      texture.anisotropy = nearest ? 1 : 8;
      texture.colorSpace = srgb ? THREE.SRGBColorSpace : THREE.NoColorSpace;
      texture.needsUpdate = true;
      resolve(texture);
    };
    entry.texture = loader.load(new URL(file, import.meta.url).href, set, undefined, reject);
  });
  loaded.set(uniform, entry);
  return entry;
}

// 32-bit floats where they can be filtered and have mips.
function floatType() {
  const gl = document.createElement('canvas').getContext('webgl2');
  const full = gl?.getExtension('OES_texture_float_linear') && gl.getExtension('EXT_color_buffer_float');
  return full ? THREE.FloatType : THREE.HalfFloatType;
}

