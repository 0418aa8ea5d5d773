function assign(uniform, value) {
  if (typeof uniform.value === 'number') uniform.value = value;
  else if (uniform.value.isColor && !Array.isArray(value)) uniform.value.set(value);
  else if (Array.isArray(value)) uniform.value.fromArray(value);
  else uniform.value.copy(value);
}

