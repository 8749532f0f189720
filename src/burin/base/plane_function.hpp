#pragma once

#include <functional>
#include <memory>
#include <string>

namespace burin {

/// A function of two numbers that has a name in expressions, such as the brightness of an image. Const and free of
/// state: it may be called on several threads at once.
struct PlaneFunction {
  std::string name;
  std::shared_ptr<const std::function<double(double, double)>> value;
};

}  // namespace burin
