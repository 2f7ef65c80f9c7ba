#include "workbench/cli/compiled.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>

#include "compiler/text/user_error.hpp"
#include "workbench/host/large_pages.hpp"
#include "workbench/host/progress.hpp"

namespace mbgen::cli {

Compilation compiled(Model model, CompileOptions options) {
  take_large_pages(model.bodies.size());
  const std::string name = model.name;
  const std::size_t stages = stage_names().size();
  std::size_t ended = 0;
  StatusLine line;
  options.watch = [&](const Stage&) {
    ++ended;
    if (line.is_due()) line.show(fmt::format("translating {}: {} of {} stages", name, ended, stages));
    return true;
  };
  return expect(compile(std::move(model), options));
}

}  // namespace mbgen::cli
