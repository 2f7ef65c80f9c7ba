# From "name symbol offset" to rows of the application's table: the place that C has for the name.
{
  split($1, part, ".")
  group = part[2]
  member = part[3]
  if (group == "t") place = solver "_a2l_state.t"
  else if (group == "z" || group == "zd" || group == "x") place = solver "_a2l_state." group "[place_of(\"" group "\", \"" member "\")]"
  else place = solver "_a2l_" group "." member
  printf "  check(\"%s\", &%s, &%s, %d);\n", $1, place, $2, $3
}
