// Bytes as the table of inputs of `simulate --input-table`: columns of one length, or a UserError.
#include "compiler/text/user_error.hpp"
#include "fuzz_tables.hpp"
#include "workbench/motion/input_table.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace mbgen;
  static const Compilation compilation = fuzz::small_compilation();
  try {
    const InputTable table = parse_input_table(fuzz::text_of(data, size), "table.csv", compilation.model);
    fuzz::require(!table.t.empty() && std::is_sorted(table.t.begin(), table.t.end()), "time increases");
    for (const InputColumn& column : table.columns) {
      fuzz::require(column.input >= 0 && column.input < 2, "a column has its input");
      fuzz::require(column.values.size() == table.t.size(), "columns are as long as the time");
    }
  } catch (const UserError& error) {
    fuzz::require(error.what()[0] != 0, "an error has a text");
  }
  return 0;
}
