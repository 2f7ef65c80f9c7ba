// Colours of the page, light or dark as the system is.

const query = window.matchMedia("(prefers-color-scheme: dark)");

/** A colour of style.css. */
export function colour(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
}

/** Colours of curves, apart for people who see colours otherwise too (Okabe and Ito). */
export function curveColour(index) {
  const colours = query.matches
    ? ["#5aa9e6", "#f08a4b", "#3cc28f", "#e58bc5", "#e6c14c", "#8ed3f7", "#c9ced6", "#b694f0"]
    : ["#0b63a5", "#c8501e", "#00805d", "#a0447f", "#a87900", "#2b8fbf", "#4d4d4d", "#7a3fb0"];
  return colours[index % colours.length];
}

export function onThemeChange(listener) {
  query.addEventListener("change", listener);
}
