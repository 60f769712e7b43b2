// SPDX-License-Identifier: MIT
// Numbers for people, and elements of the page. A missing number is a dash, never NaN.
const Format = (() => {
  const dash = '\u2013';
  const superscripts = {
    '-': '\u207b',
    0: '\u2070',
    1: '\u00b9',
    2: '\u00b2',
    3: '\u00b3',
    4: '\u2074',
    5: '\u2075',
    6: '\u2076',
    7: '\u2077',
    8: '\u2078',
    9: '\u2079'
  };

  const isNumber = (x) => typeof x === 'number' && Number.isFinite(x);
  const power = (n) => '10' + [...String(n)].map((c) => superscripts[c]).join('');
  /** The digits of a whole number, in threes. */
  const grouped = (n) => String(n).replace(/\B(?=(\d{3})+$)/g, ',');

  function positive(x) {
    if (x >= 999.5) return x < 1e7 ? grouped(Math.round(x)) : scientific(x);
    return x >= 0.000995 ? x.toPrecision(3) : scientific(x);
  }
  function scientific(x) {
    const [mantissa, exponent] = x.toExponential(1).split('e');
    return `${mantissa}\u00b7${power(Number(exponent))}`;
  }

  /** Three digits; powers of ten where they would be zeros. */
  function num(x) {
    if (!isNumber(x)) return dash;
    if (x === 0) return '0';
    return (x < 0 ? '\u2212' : '') + positive(Math.abs(x));
  }
  /** Without zeros at the end, for factors and edges. */
  function plain(x) {
    if (!isNumber(x)) return dash;
    const rounded = Number(x.toPrecision(3));
    return Number.isInteger(rounded) && Math.abs(rounded) < 1e7 ? grouped(rounded) : String(rounded);
  }
  const signed = (x) => (isNumber(x) && x > 0 ? '+' : '') + num(x);
  const count = (n) => (isNumber(n) ? grouped(Math.round(n)) : dash);
  const percent = (x) => (isNumber(x) ? num(100 * x) : dash);
  /** A relative change in percent; what more than doubles is a factor. */
  const change = (x) => (isNumber(x) && x > 1 ? `\u00d7${plain(1 + x)}` : signed(isNumber(x) ? 100 * x : x));

  // Half the spacing of floats at 1: directions of float velocities differ by as much without any fault.
  const angleRounding = 2 ** -24;
  const isRounding = (x) => isNumber(x) && x !== 0 && Math.abs(x) < angleRounding;
  /** An angle in radians. */
  const angle = (x) => (isRounding(x) ? '0 (rounding)' : num(x));

  const degree = Math.PI / 180;
  /** Degrees of an angle in radians, as people say them. */
  function degrees(x) {
    if (!isNumber(x)) return dash;
    const d = x / degree;
    return d < 0.001 ? '<0.001\u00b0' : `${d < 9.95 ? plain(Number(d.toPrecision(2))) : Math.round(d)}\u00b0`;
  }
  /** Both, for tables. */
  const bothAngles = (x) =>
      (isNumber(x) && !isRounding(x) && x !== 0 ? `${angle(x)} (${degrees(x)})` : angle(x));

  /** "none of 2,000", "1 in 40", "45%" above a quarter. */
  function lossText(r, n) {
    if (!r || !isNumber(r.count) || !(n > 0)) return dash;
    if (r.count === 0) return `none of ${count(n)}`;
    if (4 * r.count > n) return `${Math.round(100 * r.count / n)}%`;
    const one = Number((n / r.count).toPrecision(2));
    return `1 in ${one < 10 ? one : count(one)}`;
  }

  function interval(pair, scale = 1) {
    if (!Array.isArray(pair) || !isNumber(pair[0]) || !isNumber(pair[1])) return '';
    return `${num(scale * pair[0])}${dash}${num(scale * pair[1])}`;
  }

  /** A rate in percent. None seen in n is no zero: at 95% it is below 3 in n. */
  function rate(r) {
    if (!r || !isNumber(r.count) || !(r.of > 0)) return dash;
    if (r.count > 0) return percent(r.count / r.of);
    return r.of > 3 ? `< ${percent(3 / r.of)}` : `none in ${count(r.of)}`;
  }
  const rateInterval = (r) => (r && r.count > 0 && r.of > 0 ? interval([r.low, r.high], 100) : '');

  /** Nanoseconds in the unit that suits. */
  const time = (ns) => withUnit(ns, num);
  const plainTime = (ns) => withUnit(ns, plain);
  function withUnit(ns, format) {
    if (!isNumber(ns)) return dash;
    const [unit, size] = ns < 999.5     ? ['ns', 1]
                         : ns < 999.5e3 ? ['\u00b5s', 1e3]
                         : ns < 999.5e6 ? ['ms', 1e6]
                                        : ['s', 1e9];
    return `${format(ns / size)}\u00a0${unit}`;
  }

  /** An element. Attributes that begin with "on" are listeners, those that are null or false are left out. */
  function el(tag, attributes, ...children) {
    const element = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes ?? {})) {
      if (name.startsWith('on'))
        element.addEventListener(name.slice(2), value);
      else if (name.startsWith('--'))
        element.style.setProperty(name, value);
      else if (value !== null && value !== undefined && value !== false)
        element.setAttribute(name, value === true ? '' : value);
    }
    element.append(
        ...children.flat(Infinity).filter((child) => child !== null && child !== undefined && child !== ''));
    return element;
  }
  /** A figure with its interval, if there is one. */
  const withInterval = (text, range) =>
      (range ? [text, ' ', el('span', {class: 'interval'}, `(${range})`)] : [text]);
  const rateWithInterval = (r) => {
    const of = r && isNumber(r.count) && r.of > 0 ? `${count(r.count)} of ${count(r.of)}` : '';
    return withInterval(rate(r), [rateInterval(r), of].filter(Boolean).join('; '));
  };
  /** Median and 95th percentile. */
  const summary = (s, format = num) => (s && s.count > 0 ? `${format(s.median)} / ${format(s.p95)}` : dash);
  const angles = (s) => summary(s, bothAngles);

  /** A sentence of the program, with signs that a terminal may not have. */
  const spoken = (text) => String(text ?? '').replace(/ degrees\b/g, '\u00b0');
  const sentences = (list) =>
      el('ul', {class: 'sentences'}, (list ?? []).map((s) => el('li', null, spoken(s))));

  return {
    dash,
    isNumber,
    num,
    plain,
    signed,
    count,
    percent,
    change,
    angle,
    angles,
    degrees,
    bothAngles,
    lossText,
    interval,
    rate,
    rateInterval,
    time,
    plainTime,
    power,
    el,
    withInterval,
    rateWithInterval,
    summary,
    spoken,
    sentences
  };
})();
