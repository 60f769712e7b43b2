// SPDX-License-Identifier: MIT
// A game as what was pressed: the same seed, keys and switches of the engine give the same game. As a link:
// #pinball=SEED.MODE.EVENTS, each event the frames since the last one in base 36, and k and the keys, m and the mode, or e
// for the end, separated by dots.
const newRecord = (game, mode, seed) => ({game: games[game], mode: modes[mode], seed, events: []});

function note(record, frame, kind, value) {
  record.events.push([frame, kind, value]);
}

function toLink(record, frame) {
  let last = 0;
  const events = [...record.events, [frame, 'e', 0]].map(([at, kind, value]) => {
    const text = `${(at - last).toString(36)}${kind.toUpperCase()}${kind === 'e' ? '' : value.toString(36)}`;
    last = at;
    return text;
  });
  return `#${record.game}=${[record.seed, modes.indexOf(record.mode), ...events].join('.')}`;
}

/** @throws Error that says what is wrong */
function fromLink(hash) {
  const [, game, text] = /^#(\w+)=([\w.]+)$/.exec(hash) ?? [];
  if (!games.includes(game)) throw new Error(`The link names no game: expected one of ${games.join(', ')}.`);
  const [seed, mode, ...events] = text.split('.');
  const record = {game, mode: modes[Number(mode)], seed: Number(seed), events: []};
  let at = 0;
  for (const event of events) {
    const [, wait, kind, value] = /^([0-9a-z]+)([KME])([0-9a-z]*)$/.exec(event) ?? [];
    if (!kind) throw new Error(`The link has the event '${event}': expected frames, then K, M or E, then a number.`);
    at += parseInt(wait, 36);
    note(record, at, kind.toLowerCase(), parseInt(value || '0', 36));
  }
  return checked(record);
}

/** @throws Error that says what is wrong */
function checked(record) {
  if (!games.includes(record.game)) throw new Error(`game is '${record.game}': expected one of ${games.join(', ')}.`);
  if (!modes.includes(record.mode)) throw new Error(`mode is '${record.mode}': expected one of ${modes.join(', ')}.`);
  if (!Number.isInteger(record.seed) || record.seed < 0 || record.seed > 0xffffffff)
    throw new Error(`seed is '${record.seed}': expected a whole number from 0 to 4294967295.`);
  const isEvent = ([at, kind, value]) => Number.isInteger(at) && at >= 0 && Number.isInteger(value) &&
      (kind === 'e' || (kind === 'k' && value >= 0 && value < 16) || (kind === 'm' && value >= 0 && value < modes.length));
  const odd = Array.isArray(record.events) ? record.events.findIndex((event) => !Array.isArray(event) || !isEvent(event)) : 0;
  if (odd !== -1) throw new Error(`events[${odd}] is no event: expected [frame, "k", keys], [frame, "m", mode] or [frame, "e", 0].`);
  return record;
}
