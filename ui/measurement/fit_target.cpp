#include "ui/measurement/fit_target.h"

#include <QCoreApplication>
#include <algorithm>

#include "sim/core/schema_tree.h"
#include "sim/document/drive_stand.h"
#include "sim/fitting/doubt.h"
#include "sim/propulsion/rotor/rotor.h"
#include "ui/forms/field_text.h"
#include "ui/forms/snapshot.h"

namespace rotorbench {

namespace {

struct Found {
  QString path;
  const void* object = nullptr;
};

/// The first struct of this type in the order of the document.
template <class T>
std::optional<Found> firstOf(schema::ConstRef root) {
  std::optional<Found> found;
  schema::walk(root, [&](const std::string& path, const schema::Field& field, const void* owner) {
    if (found || field.isLeaf() || field.kind == schema::Kind::List) return;
    if (&field.childType(owner, 0) != &schema::typeOf<T>()) return;
    found = Found{toQString(path), field.constChild(owner, 0)};
  });
  return found;
}

template <class T>
const T* objectIn(schema::ConstRef root) {
  const auto found = firstOf<T>(root);
  return found ? static_cast<const T*>(found->object) : nullptr;
}

/// The lumped rotor of the experiment in any of its three forms, as k_f and k_m at a density of
/// 1.225 kg/m^3.
std::optional<RotorCoefficients> lumpedIn(schema::ConstRef root) {
  if (const auto* rotor = objectIn<RotorCoefficients>(root)) return *rotor;
  double ct = 0, cp = 0, diameter = 0;
  if (const auto* p = objectIn<PropellerCoefficients>(root)) {
    ct = p->thrustCoefficient, cp = p->powerCoefficient, diameter = p->diameter;
  } else if (const auto* load = objectIn<PropellerLoad>(root)) {
    ct = load->thrustCoefficient, cp = load->powerCoefficient, diameter = load->diameter;
  } else {
    return std::nullopt;
  }
  RotorCoefficients rotor;
  rotor.diameter = diameter;
  rotor.thrust = ct / thrustCoefficientOf(1, rotor.referenceDensity, diameter);
  rotor.torque = cp / powerCoefficientOf(1, rotor.referenceDensity, diameter);
  return rotor;
}

struct ComponentOf {
  const FitStart& start;
  const FitResult& result;
  const std::string& source;
  const RotorCoefficients lumped;

  /// A doubtful value is known for one wherever it is picked later.
  [[nodiscard]] ComponentInfo info(const char* summary) const {
    return {{}, summary, source, doubtsOf(result).empty() ? std::string() : verdictOf(result)};
  }
  Component operator()(const MotorFitRequest& r) const {
    return makeComponent(info("Motor constants fitted to measured data"),
                         motorFrom(result, setupOf(r, start)).motor);
  }
  Component operator()(const PropellerFitRequest& r) const {
    return makeComponent(info("Propeller fitted to measured data"),
                         propellerFrom(result, setupOf(r, start)));
  }
  Component operator()(const RotorFitRequest& r) const {
    RotorCoefficients rotor = lumped;
    // What moving air does keeps its values; they hold at another density now.
    const double change = r.airDensity / rotor.referenceDensity;
    rotor.inflow.drag *= change;
    rotor.inflow.inflow *= change;
    rotor.inflow.translationalLift *= change;
    rotor.inflow.flapping *= change;
    rotor.thrust *= change;
    rotor.torque *= change;
    rotor.referenceDensity = r.airDensity;
    const auto* thrust = result.find("thrust");
    const auto* torque = result.find("torque");
    if (thrust != nullptr && thrust->determined) rotor.thrust = thrust->value;
    if (torque != nullptr && torque->determined) rotor.torque = torque->value;
    return makeComponent(info("Lumped rotor fitted to measured data"), rotor);
  }
};

}  // namespace

FitTarget::FitTarget(DocumentModel& experiment) : experiment_(experiment) {}

FitStart FitTarget::start() const {
  const schema::ConstRef root = experiment_.root();
  FitStart start;
  const auto* motor = objectIn<MotorParameters>(root);
  if (motor != nullptr) start.motor = *motor;
  if (const auto* esc = objectIn<EscParameters>(root)) {
    start.escResistance = esc->resistance;
    start.currentLimit =
        motor != nullptr ? std::min(esc->maxCurrent, motor->maxCurrent) : esc->maxCurrent;
  }
  if (const auto* propeller = objectIn<PropellerGeometry>(root)) start.propeller = *propeller;
  if (const auto* settings = objectIn<BladeElementSettings>(root)) start.settings = *settings;
  if (const auto lumped = lumpedIn(root)) {
    start.coefficientsAreGuesses = false;
    start.thrustCoefficient = lumped->thrust;
    start.torqueCoefficient = lumped->torque;
  }
  return start;
}

std::optional<Component> FitTarget::component(const FitRequest& request, const FitStart& start,
                                              const FitResult& result,
                                              const std::string& source) const {
  if (!result.usable()) return std::nullopt;
  const auto lumped = lumpedIn(experiment_.root()).value_or(RotorCoefficients{});
  return std::visit(ComponentOf{start, result, source, lumped}, request.what);
}

QString FitTarget::pathFor(const FitRequest& request) const {
  const schema::ConstRef root = experiment_.root();
  const auto pathOf = [](const std::optional<Found>& found) {
    return found ? found->path : QString();
  };
  if (std::holds_alternative<MotorFitRequest>(request.what))
    return pathOf(firstOf<MotorParameters>(root));
  if (std::holds_alternative<PropellerFitRequest>(request.what))
    return pathOf(firstOf<PropellerGeometry>(root));
  for (const auto& found : {firstOf<RotorCoefficients>(root), firstOf<PropellerCoefficients>(root),
                            firstOf<PropellerLoad>(root)}) {
    if (found) return found->path;
  }
  return {};
}

QString FitTarget::place(const FitRequest& request) const {
  const QString path = pathFor(request);
  return path.isEmpty() ? QString() : placeText(experiment_.root(), path);
}

void FitTarget::use(const FitRequest& request, const Component& component) {
  const QString path = pathFor(request);
  const auto object = experiment_.object(path);
  if (path.isEmpty() || !object) return;
  const QString text = QCoreApplication::translate("FitTarget", "Use the fit");
  if (object->type == component.type) {
    experiment_.replaceObject(path, capture(component.ref()), text);
    return;
  }
  // A lumped rotor in the form the experiment has it.
  const auto& rotor = *component.as<RotorCoefficients>();
  const double density = rotor.referenceDensity;
  if (object->type == &schema::typeOf<PropellerCoefficients>()) {
    auto p = *static_cast<const PropellerCoefficients*>(object->object);
    p.thrustCoefficient = thrustCoefficientOf(rotor.thrust, density, p.diameter);
    p.powerCoefficient = powerCoefficientOf(rotor.torque, density, p.diameter);
    experiment_.replaceObject(path, capture(schema::ref(p)), text);
  } else if (object->type == &schema::typeOf<PropellerLoad>()) {
    auto p = *static_cast<const PropellerLoad*>(object->object);
    p.thrustCoefficient = thrustCoefficientOf(rotor.thrust, density, p.diameter);
    p.powerCoefficient = powerCoefficientOf(rotor.torque, density, p.diameter);
    experiment_.replaceObject(path, capture(schema::ref(p)), text);
  }
}

}  // namespace rotorbench
