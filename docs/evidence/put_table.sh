# Tables of the pages in this folder, for scripts that measure them anew. Requires: $scratch, a directory.

# put NAME PAGE: the table of standard input between the markers of that name.
put() {
  cat > "$scratch/table_$1"
  awk -v table="$scratch/table_$1" -v name="$1" '
    $0 == "<!-- " name ": end -->" { inside = 0 }
    !inside { print }
    $0 == "<!-- " name ": begin -->" {
      inside = 1
      while ((getline line < table) > 0) print line
    }' "$2" > "$scratch/page"
  cat "$scratch/page" > "$2"
}
