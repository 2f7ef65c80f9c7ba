// The time that the page shows, and its course while it plays.

/**
 * Time between start and end (s); at the end it stops, or begins again where it loops. Listeners are told of every
 * change: ({time, playing, speed}).
 */
export function createPlayer({ start, end }, loops) {
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
    const time = state.time + passed * state.speed;
    if (loops) {
      state.time = state.start + ((time - state.start) % (state.end - state.start));
    } else {
      state.time = Math.min(state.end, time);
      state.playing = time < state.end;
    }
    tell();
  }

  return {
    state,
    seek,
    advance,
    toggle: () => setPlaying(!state.playing),
    play: () => setPlaying(true),
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
