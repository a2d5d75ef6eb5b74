#include "lcmtypes/bus/convert.h"

#include "lcmtypes/bus/cross_rules.h"
#include "lcmtypes/bus/field_copier.h"
#include "lcmtypes/bus/message_fields.h"  // fields() of every struct, made by lcmtypes/generate.py

namespace twinbus::inline lcmtypes {

template <class T>
Status to_message(const T& value, Message<T>& message) noexcept {
  Copier<true> copier;
  fields(copier, message, value);
  return copier.status();
}

template <class T>
Status from_message(const Message<T>& message, T& value) noexcept {
  Copier<false> copier;
  fields(copier, message, value);
  return copier.status();
}

#define TWINBUS_CONVERT(T)                                       \
  template Status to_message<T>(const T&, Message<T>&) noexcept; \
  template Status from_message<T>(const Message<T>&, T&) noexcept;
TWINBUS_MESSAGES(TWINBUS_CONVERT)
#undef TWINBUS_CONVERT

}  // namespace twinbus::lcmtypes
