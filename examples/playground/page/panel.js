// SPDX-License-Identifier: MIT
// The engines with what they cost, and what is simulated.
const $ = (id) => document.getElementById(id);
const costs = modes.map(() => null); // nanoseconds for a step
const measuredFor = 1;               // milliseconds
const mostMeasuredBalls = 100;

function showCosts() {
  [...$('modes').children].forEach((button, i) => {
    button.setAttribute('aria-checked', i === state.mode);
    button.lastChild.textContent = !(costs[i] > 0) ? '' : `${Math.round(costs[i]).toLocaleString('en')} ns`;
  });
}

let nextMeasured = 0, lastMeasured = 0;
/** One engine after the other, ten times a second. Where balls are many, a step takes too long for a game that goes on. */
function measureNext(now) {
  if (now - lastMeasured < 100 || (engine._GetBallCount() > mostMeasuredBalls && !state.isPaused)) return;
  lastMeasured = now;
  const cost = engine._Measure(nextMeasured, measuredFor), old = costs[nextMeasured];
  // The first ones are not compiled to the end yet.
  costs[nextMeasured] = old === null ? NaN : old > 0 ? 0.8 * old + 0.2 * cost : cost;
  nextMeasured = (nextMeasured + 1) % modes.length;
  showCosts();
}

let explained = '';
function showEffects() {
  const text = textAt(engine._Explain());
  if (text === explained) return;
  explained = text;
  const rows = text.trim().split('\n').map((line) => {
    const [, name, does, why] = /^(\w+): (runs|does not run)[;,]? ?(.*)$/.exec(line) ?? [null, line, 'runs', ''];
    const term = document.createElement('dt'), reason = document.createElement('dd');
    term.textContent = name;
    term.className = does === 'runs' ? '' : 'off';
    term.title = does;
    reason.textContent = why;
    return [term, reason];
  });
  $('effects').replaceChildren(...rows.flat());
}

// Only what has changed is written: the page lays itself out anew each time.
function write(id, text) {
  if ($(id).textContent !== text) $(id).textContent = text;
}

/** The best score of this game that this browser knows. */
function best(score) {
  const key = `shapes ${games[state.game]}`;
  if (state.best === null) {
    try { // a browser may keep nothing for files
      state.best = Number(localStorage.getItem(key));
    } catch { state.best = 0; }
  }
  if (score <= state.best) return state.best;
  state.best = score;
  try { localStorage.setItem(key, score); } catch { /* it is known until the page is closed */ }
  return score;
}

function showScore() {
  const score = engine._GetScore(), unit = units[games[state.game]], lost = engine._GetLost();
  write('score', score.toLocaleString('en'));
  write('unit', unit === 'points' ? `points, best ${best(score).toLocaleString('en')}` : unit);
  $('scene').disabled = engine._GetBallCount() === 0; // a scene has at least one
  write('status', textAt(engine._GetStatus()));
  write('lost', lost === 0 ? 'No ball got through a wall.' :
      `Balls that got through a wall, and were put back: ${lost.toLocaleString('en')}`);
}
