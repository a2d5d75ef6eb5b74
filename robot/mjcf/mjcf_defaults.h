// Default classes of an MJCF model: what an element has that does not say it.

#pragma once

#include <map>
#include <string>

#include "robot/mjcf/mjcf_element.h"

namespace twinbus::inline robot {

class MjcfDefaults {
 public:
  // Reads the <default> sections of a model.  Throws for a class without a name or that is there twice.
  explicit MjcfDefaults(const MjcfElement& mujoco);

  // The element with the attributes of its class added: of its own attribute `class`, else of `childclass`, which may be
  // empty.  Throws if there is no such class.
  MjcfElement resolved(const MjcfElement& element, const std::string& childclass) const;

  // Throws, naming the element's childclass, if there is no such class.
  void check_childclass(const MjcfElement& element) const;

 private:
  using Class = std::map<std::string, std::vector<MjcfAttribute>>;  // kind of element to its attributes

  void read(const MjcfElement& section, const Class& parent, const std::string& name);
  const Class& find(const MjcfElement& element, const std::string& key, const std::string& name) const;

  std::map<std::string, Class> classes_;
  std::string top_ = "main";
};

// Whether an element is an actuator: all kinds share their defaults.
bool is_actuator_element(const std::string& name);

}  // namespace twinbus::robot
