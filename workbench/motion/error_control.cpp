#include "workbench/motion/error_control.hpp"

namespace mbgen {

const char* name_of(ErrorControl::Method method) {
  return method == ErrorControl::Method::bdf ? "cvode" : "cvode-adams";
}

}  // namespace mbgen
