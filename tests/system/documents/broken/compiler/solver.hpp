// theory.md sections 1 and 2, docs/method/theory.md section 1, theory.md, "2 Inertias": these exist.
// Two of three: theory.md
// sections 1 to 3.
// Written otherwise: theory.md 2. No such page: design.md section 7. No such heading: docs/method/theory.md,
// "Inertias". A page by a path that it has not: docs/theory.md.
