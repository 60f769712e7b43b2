// SPDX-License-Identifier: MIT
// The engines of Playground.cpp, and what the page says of each game.
const engine = await createPlayground();
const textAt = (pointer) => engine.UTF8ToString(pointer);
const named = (count, name) => Array.from({length: count}, (_, i) => textAt(name(i)));

const games = named(engine._GetGameCount(), engine._GetGameName);
const modes = named(engine._GetModeCount(), engine._GetModeName);
const framesPerSecond = 60;

const keyBits = {left: 1, right: 2, action: 4, nudge: 8};
const help = {
  pinball: 'Hold Space and let go: plunger. ← → flippers. ↑ nudges.',
  pile: '← → stir. Space throws everything up.',
  billiard: 'Watch the mean free path run towards π A/P. Space starts anew.',
  breakout: '← → or the mouse move the paddle. Space serves.',
};
const units = {pinball: 'points', pile: 'times past the line', billiard: 'bounces', breakout: 'points'};
const padNames = {
  pinball: {left: '← Flip', action: 'Plunger', nudge: 'Nudge', right: 'Flip →'},
  pile: {left: '← Stir', action: 'Throw', right: 'Stir →'},
  billiard: {action: 'Start anew'},
  breakout: {left: '←', action: 'Serve', right: '→'},
};
