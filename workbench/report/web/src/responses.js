// Frequency responses below the modes: magnitudes and phases over a logarithmic frequency.

import { createDiagram } from "./diagram.js";

/** Shows the responses in the page's section. Nothing where there are none. */
export function writeResponses(responses, section, target) {
  if (!responses || responses.length === 0) return;
  section.hidden = false;
  target.append(...responses.map(createDiagram));
}
