#include "sim/sizing/lumping.h"

#include "sim/core/schema_tree.h"
#include "sim/document/flight.h"
#include "sim/document/propeller_bench.h"
#include "sim/sizing/steady_flight.h"

namespace rotorbench {

namespace {

using schema::Field;
using schema::Kind;

/// Which alternative of a variant lumped coefficients are, if any.
std::optional<std::size_t> lumpedOption(const Field& field) {
  if (field.kind != Kind::Variant) return std::nullopt;
  for (std::size_t i = 0; i < field.options.size(); ++i)
    if (&field.alternativeType(i) == &schema::typeOf<RotorCoefficients>()) return i;
  return std::nullopt;
}

std::optional<RotorAerodynamics> modelIn(const schema::Type& type, const void* object) {
  if (&type == &schema::typeOf<MapPropeller>()) return *static_cast<const MapPropeller*>(object);
  if (&type == &schema::typeOf<BladeElementPropeller>())
    return *static_cast<const BladeElementPropeller*>(object);
  if (&type == &schema::typeOf<MeasuredPropeller>())
    return *static_cast<const MeasuredPropeller*>(object);
  if (&type == &schema::typeOf<PropellerCoefficients>())
    return *static_cast<const PropellerCoefficients*>(object);
  if (&type == &schema::typeOf<BladeElementSpecimen>()) {
    const auto& specimen = *static_cast<const BladeElementSpecimen*>(object);
    return BladeElementPropeller{specimen.geometry, specimen.settings};
  }
  return std::nullopt;
}

/// Number of the rotor in "...rotors[2]...", or 0.
std::size_t rotorIndex(const std::string& path) {
  const std::size_t at = path.find("rotors[");
  return at == std::string::npos ? 0 : std::stoul(path.substr(at + 7));
}

}  // namespace

std::vector<RotorModelAt> rotorModelsIn(schema::ConstRef root) {
  std::vector<RotorModelAt> found;
  schema::walk(root, [&](const std::string& path, const Field& field, const void* owner) {
    if (!lumpedOption(field)) return;
    if (auto model = modelIn(field.childType(owner, 0), field.constChild(owner, 0)))
      found.push_back({path, std::move(*model)});
  });
  return found;
}

std::optional<LumpingRange> lumpingRangeOf(const Experiment& experiment,
                                           const RotorModelAt& rotor) {
  const auto* flight = alternativeIf<Flight>(experiment.setup);
  if (flight == nullptr || !rotor.path.starts_with("setup.vehicle.")) return std::nullopt;
  try {
    const SteadyFlight steady(flight->vehicle, flight->environment);
    const auto hover = steady.hover();
    const auto index = static_cast<Eigen::Index>(rotorIndex(rotor.path));
    if (!hover || index >= hover->count || !(hover->speeds[index] > 0)) return std::nullopt;
    return lumpingRange(rotor.model, hover->speeds[index], steady.density());
  } catch (const InputError&) {
    return std::nullopt;
  }
}

FigureSheet lumpingSheet(const LumpedEquivalent& lumped, const LumpingRange& range) {
  const RotorCoefficients& c = lumped.coefficients;
  const LumpingErrors& e = lumped.errors;
  FigureSheet sheet;
  FigureGroup at(sheet, "at", "About");
  at.add("speed", "Rotor speed", "w", range.speed, "rad/s", "rpm", "given, or that of the hover");
  at.add("density", "Air density", "rho", range.density, "kg/m^3", "kg/m^3", "of the air flown in");
  at.add("inPlane", "In-plane air speed up to", "u", range.inPlane, "m/s", "m/s",
         "a tenth of the tips' speed unless given");
  at.add("axial", "Climb and descent up to", "V", range.axial, "m/s", "m/s",
         "0.4 of the induced velocity unless given");
  const char* source = "Svacha, Mohta, Kumar, ICUAS 2017; least squares over the air speeds";
  FigureGroup k(sheet, "lumped", "Lumped coefficients");
  k.add("thrust", "Thrust coefficient", "k_eta", c.thrust, "N*s^2", "N*s^2", "T/w^2 at rest");
  k.add("torque", "Torque coefficient", "k_m", c.torque, "N*m*s^2", "N*m*s^2", "Q/w^2 at rest");
  k.add("inflow", "Inflow loss", "k_z", c.inflow.inflow, "N*s^2/m", "N*s^2/m",
        "T - k_eta w^2 = k_h u^2 - k_z w V", source);
  k.add("translationalLift", "Translational lift", "k_h", c.inflow.translationalLift, "N*s^2/m^2",
        "N*s^2/m^2", "T - k_eta w^2 = k_h u^2 - k_z w V", source);
  k.add("drag", "Rotor drag", "k_d", c.inflow.drag, "N*s^2/m", "N*s^2/m", "H = k_d w u", source);
  k.add("flapping", "Hub moment", "k_flap", c.inflow.flapping, "N*s^2", "N*s^2", "M = k_flap w u",
        source);
  FigureGroup off(sheet, "off", "What they are off by (root mean square over these air speeds)");
  const char* ofThrust = "of the thrust at rest";
  const char* ofLever = "of the thrust at rest times the radius";
  off.add("thrust", "Thrust", "", e.thrust, "1", "%", ofThrust);
  off.add("torque", "Torque, which does not change with the air", "", e.torque, "1", "%",
          "of the torque at rest");
  off.add("inPlane", "In-plane force", "", e.inPlane, "1", "%", ofThrust);
  off.add("pitch", "Pitching moment", "", e.pitch, "1", "%", ofLever);
  off.add("side", "Force to the side, left out", "", e.side, "1", "%", ofThrust);
  off.add("roll", "Rolling moment, left out", "", e.roll, "1", "%", ofLever);
  constexpr double kMuch = 0.1;
  if (e.thrust > kMuch)
    sheet.warnings.emplace_back(
        "Thrust is off by more than a tenth: these coefficients hold over fewer air speeds.");
  if (e.torque > kMuch)
    sheet.warnings.emplace_back(
        "The torque changes by more than a tenth over these air speeds, and lumped coefficients "
        "keep it.");
  return sheet;
}

void useLumped(schema::Ref root, const std::string& path, const RotorCoefficients& coefficients) {
  const schema::Location at = schema::locate(root, path);
  const auto option = at.field == nullptr ? std::nullopt : lumpedOption(*at.field);
  if (!option)
    throw InputError({}, {{path, "takes no lumped coefficients", "the model of a rotor"}});
  at.field->choose(at.owner, *option);
  *static_cast<RotorCoefficients*>(at.field->child(at.owner, 0)) = coefficients;
}

}  // namespace rotorbench
