// The result that the page carries: one JSON block whose columns are doubles, little-endian, in base64.

/** The doubles of `text`; a column that never changes is stored as one value. */
function decode(text, rows) {
  const bytes = Uint8Array.from(atob(text), (character) => character.charCodeAt(0));
  const values = new Float64Array(bytes.buffer);
  return values.length === rows ? values : new Float64Array(rows).fill(values[0]);
}

/** What write_page (page.hpp) wrote into `element`, its columns decoded. The first column is time. */
export function readResult(element) {
  const result = JSON.parse(element.textContent);
  const columns = result.columns.map(({ name, values }) => ({ name, values: decode(values, result.rows) }));
  return { ...result, columns, times: columns[0].values };
}

/** The last row whose time is not after `time`; the first if there is none. */
export function rowBefore(times, time) {
  let low = 0;
  let high = times.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (times[middle] <= time) low = middle;
    else high = middle - 1;
  }
  return low;
}

export function nearestRow(times, time) {
  const row = rowBefore(times, time);
  return row + 1 < times.length && times[row + 1] - time < time - times[row] ? row + 1 : row;
}
