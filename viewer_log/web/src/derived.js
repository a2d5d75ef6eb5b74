// Numbers that nobody says but that follow from those that were heard: `= STATE.q.A - STATE.q.B`, `= d(SHOWN.com.x)`.
//
// + - * / and brackets; d(x): per second; abs(x), sqrt(x). A name is a column of the history.

const kFunctions = { abs: Math.abs, sqrt: Math.sqrt };

function tokens(text) {
  const found = text.match(/[A-Za-z_][\w.]*|\d+\.?\d*(?:e-?\d+)?|[-+*/()]|\S/g) ?? [];
  if (found.some((token) => !/^([A-Za-z_][\w.]*|\d.*|[-+*/()])$/.test(token))) throw new Error('only names, numbers, + - * / and brackets');
  return found;
}

// Gives what computes it: (rows) => values, null where one is missing. history: pick() and time. Throws an Error with a sentence.
export function derive(text, history) {
  const left = tokens(text.replace(/^=/, ''));
  const name = (token) => {
    if (!history.columns.has(token)) throw new Error(`nothing called ${token} was heard`);
    return (rows) => history.pick(token, rows);
  };
  const each = (a, b, how) => (rows) => {
    const [x, y] = [a(rows), b(rows)];
    return x.map((v, i) => (v === null || y[i] === null || !Number.isFinite(how(v, y[i])) ? null : how(v, y[i])));
  };
  const slope = (inner) => (rows) => {
    const values = inner(rows);
    return values.map((v, i) => {
      const dt = i === 0 ? 0 : history.time[rows[i]] - history.time[rows[i - 1]];
      return v === null || !(dt > 0) || values[i - 1] === null ? null : (v - values[i - 1]) / dt;
    });
  };
  const one = () => {
    const token = left.shift();
    if (token === undefined) throw new Error('something is missing at the end');
    if (token === '-') { const inner = one(); return (rows) => inner(rows).map((v) => (v === null ? null : -v)); }
    if (token === '(') { const inner = sum(); close(); return inner; }
    if (/^\d/.test(token)) return (rows) => rows.map(() => Number(token));
    if (left[0] === '(' && (token === 'd' || kFunctions[token])) {
      left.shift();
      const inner = sum();
      close();
      return token === 'd' ? slope(inner) : each(inner, (rows) => rows.map(() => 0), (v) => kFunctions[token](v));
    }
    if (!/^[A-Za-z_]/.test(token)) throw new Error(`a name or number was to stand where ${token} is`);
    return name(token);
  };
  const close = () => { if (left.shift() !== ')') throw new Error('a bracket is not closed'); };
  const product = () => {
    let value = one();
    while (left[0] === '*' || left[0] === '/') value = left.shift() === '*' ? each(value, one(), (x, y) => x * y) : each(value, one(), (x, y) => x / y);
    return value;
  };
  const sum = () => {
    let value = product();
    while (left[0] === '+' || left[0] === '-') value = left.shift() === '+' ? each(value, product(), (x, y) => x + y) : each(value, product(), (x, y) => x - y);
    return value;
  };
  const value = sum();
  if (left.length > 0) throw new Error(`${left[0]} is one too many`);
  return value;
}
