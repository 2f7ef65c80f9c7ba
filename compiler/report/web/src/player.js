// The time that the page shows, and its course while it plays.

/** Time between start and end (s). Listeners are told of every change: ({time, playing, speed}). */
export function createPlayer(start, end) {
  const state = { time: start, start, end, playing: false, speed: 1 };
  const listeners = [];
  let last = null;

  const tell = () => listeners.forEach((listener) => listener(state));

  function seek(time) {
    state.time = Math.min(state.end, Math.max(state.start, time));
    tell();
  }

  function setPlaying(playing) {
    if (playing && state.time >= state.end) state.time = state.start;
    state.playing = playing;
    last = null;
    tell();
  }

  /** To be called before each picture, with its time in ms. */
  function advance(now) {
    if (!state.playing) return;
    const passed = last === null ? 0 : (now - last) / 1000;
    last = now;
    state.time = Math.min(state.end, state.time + passed * state.speed);
    if (state.time >= state.end) state.playing = false;
    tell();
  }

  return {
    state,
    seek,
    advance,
    toggle: () => setPlaying(!state.playing),
    pause: () => setPlaying(false),
    setSpeed(speed) {
      state.speed = speed;
      tell();
    },
    setRange(from, to) {
      Object.assign(state, { start: from, end: to, time: from });
      tell();
    },
    listen: (listener) => listeners.push(listener),
  };
}
