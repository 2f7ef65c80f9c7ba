# How many cases of each kind ran: from the log of a run of ctest (build/*/Testing/Temporary/LastTest.log).

function add(kind, number) {
  if (!(kind in count)) order[++kinds] = kind
  count[kind] += number
}

/^[0-9]+\/[0-9]+ Testing: / { split($3, word, /[.:]/); room = word[1]; tests = skipped = 0 }
/^\[  PASSED  \] [0-9]+ tests?\./ { tests = $4 }
/^\[  SKIPPED \] [0-9]+ tests?, listed below/ { skipped = $4 }
/^Test Passed\.$/ { add("tests of " room, tests ? tests : 1); if (skipped) add("tests of " room " that skipped", skipped) }
/^Test (Skipped|Failed|time)/ && !/^Test time/ { add("tests of " room " that " tolower($2), 1) }

/ mechanisms, [0-9]+ refused, / {
  add("random mechanisms", $1)
  add("states of random mechanisms, each for nine properties", $5)
}
/: accelerations as in Simbody/ { add("models with accelerations as in Simbody", 1) }
/: [0-9]+ joints and rods carry what Simbody says/ {
  match($0, /: [0-9]+ joints/)
  add("joints and rods with reactions as in Simbody", substr($0, RSTART + 2))
}
/: 5 s as in Simbody/ { add("motions of 5 s as in Simbody", 1) }
/: accelerations as in MuJoCo/ { add("models with accelerations as in MuJoCo", 1) }
/ mutants: [0-9]+ refused, / { add("mutated model files", $1) }
/^fuzz .*: [0-9]+ inputs, none broke it/ { add("inputs of the fuzzer", $3) }
/^package: [0-9]+ cases/ { add("uses of the installed package", $2) }
/ killed, [0-9]+ finished before/ { add("commands killed while they wrote files", $1) }

END {
  print "Cases that ran:"
  for (k = 1; k <= kinds; ++k) printf "%8d %s\n", count[order[k]], order[k]
}
