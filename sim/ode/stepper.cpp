#include "sim/ode/stepper.h"

#include <string>

#include "sim/core/error.h"

namespace rotorbench::ode {

void refuse(Method method) {
  throw InputError({}, {{"method", std::string(name(method)) + " needs a model with motor currents",
                         "any other method"}});
}

}  // namespace rotorbench::ode
