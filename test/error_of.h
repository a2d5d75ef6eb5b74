// What a call complains of.

#pragma once

#include <exception>
#include <string>

namespace twinbus::test {

// The sentence of the Error that it throws, empty if it throws nothing.
template <class Error = std::exception, class Call>
std::string error_of(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace twinbus::test
