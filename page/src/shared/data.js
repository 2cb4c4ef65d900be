// What the program has put into the page: JSON texts and columns of numbers, by name.

const ARRAYS = {
  float64: Float64Array,
  float32: Float32Array,
  int32: Int32Array,
  uint8: Uint8Array,
};

export const has = (name) => document.getElementById(name) !== null;

/** The JSON text of a name, parsed. */
export const json = (name) => JSON.parse(document.getElementById(name).textContent);

/** The numbers of a name as a typed array; its text is freed, so that it can be asked for once. */
export function column(name) {
  const block = document.getElementById(name);
  const binary = atob(block.textContent);
  const bytes = new Uint8Array(binary.length);
  for (let n = 0; n < binary.length; ++n) bytes[n] = binary.charCodeAt(n);
  block.textContent = "";
  return new ARRAYS[block.dataset.type](bytes.buffer);
}
