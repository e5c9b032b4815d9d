#include "tether_monitor/params/load_tether.h"

#include "tether_monitor/core/solve/mesh_convergence.h"

namespace tether_monitor::params
{
namespace
{
// One number, or rows of strain and tension.
void loadAxialStiffness(ParameterReader& in, const core::CableProperties* base, core::CableProperties& p)
{
  if (!in.isList("axial_stiffness"))
  {
    const bool same_as_tether = base && !in.has("axial_stiffness");
    p.axial_stiffness = base ? in.number("axial_stiffness", base->axial_stiffness) : in.number("axial_stiffness");
    p.axial_stiffening = same_as_tether ? base->axial_stiffening : core::AxialStiffening();
    return;
  }
  std::vector<core::StrainTension> rows;
  for (ParameterReader& entry : in.list("axial_stiffness"))
  {
    rows.push_back({entry.number("strain"), entry.number("tension")});
    entry.finish();
  }
  const std::vector<std::string> problems = core::validate(rows);
  for (const std::string& problem : problems)
    in.addError("axial_stiffness", ": " + problem);
  const core::AxialCurve curve = problems.empty() ? core::axialCurve(rows) : core::AxialCurve{1.0, {}};
  p.axial_stiffness = curve.stiffness;
  p.axial_stiffening = curve.stiffening;
}

// The properties from `diameter` on: of the tether, or of a section that differs from it where it says so.
void loadProperties(ParameterReader& in, const core::CableProperties* base, core::CableProperties& p)
{
  const auto required = [&](const char* key, double core::CableProperties::*member)
  { p.*member = base ? in.number(key, base->*member) : in.number(key); };
  required("diameter", &core::CableProperties::diameter);
  required("mass_per_length", &core::CableProperties::mass_per_length);
  loadAxialStiffness(in, base, p);
  p.bending_stiffness = in.number("bending_stiffness", p.bending_stiffness);
  p.axial_damping = in.number("axial_damping", p.axial_damping);
  required("drag_normal", &core::CableProperties::drag_normal);
  required("drag_tangential", &core::CableProperties::drag_tangential);
  p.added_mass_normal = in.number("added_mass_normal", p.added_mass_normal);
  p.added_mass_tangential = in.number("added_mass_tangential", p.added_mass_tangential);
  if (in.has("contact_diameter"))
    p.contact_diameter = in.optionalNumber("contact_diameter");
  if (in.has("load_area"))
    p.load_area = in.optionalNumber("load_area");
  required("working_load", &core::CableProperties::working_load);
  required("breaking_load", &core::CableProperties::breaking_load);
  p.hydrostatic_compression = in.number("hydrostatic_compression", p.hydrostatic_compression);
  p.permanent_elongation = in.number("permanent_elongation", p.permanent_elongation);
}

core::CableLayout loadFittings(ParameterReader& in, const core::CableProperties& tether)
{
  core::CableLayout layout;
  for (ParameterReader& entry : in.list("sections"))
  {
    core::CableSection section;
    section.from = entry.number("from");
    section.to = entry.number("to");
    section.properties = tether;
    loadProperties(entry, &tether, section.properties);
    if (entry.has("min_bend_radius"))
      section.properties.min_bend_radius = entry.optionalNumber("min_bend_radius");
    entry.finish();
    layout.sections.push_back(section);
  }
  for (ParameterReader& entry : in.list("attachments"))
  {
    core::Attachment attachment;
    attachment.name = entry.text("name", "");
    attachment.s = entry.number("s");
    attachment.mass = entry.number("mass");
    attachment.volume = entry.number("volume");
    attachment.drag_area = entry.number("drag_area", 0.0);
    entry.finish();
    layout.attachments.push_back(attachment);
  }
  return layout;
}
void loadUncertainty(ParameterReader in, monitor::UncertaintyConfig& u)
{
  u.drag_normal = in.number("drag_normal", u.drag_normal);
  u.drag_tangential = in.number("drag_tangential", u.drag_tangential);
  u.mass_per_length = in.number("mass_per_length", u.mass_per_length);
  u.length = in.number("length", u.length);
  u.axial_stiffness = in.number("axial_stiffness", u.axial_stiffness);
  in.finish();
}
}  // namespace

void loadTether(ParameterReader in, monitor::Config& config)
{
  core::CableProperties& p = config.tether;
  p.length = in.number("length");
  if (in.isText("elements", "auto"))
    config.accuracy = in.number("accuracy", 1e-3);
  else
    config.elements = in.integer("elements");
  if (!config.accuracy && in.has("accuracy"))
  {
    in.addError("accuracy", " is for elements: auto");
    in.ignore("accuracy");
  }
  loadProperties(in, nullptr, p);
  p.min_bend_radius = in.optionalNumber("min_bend_radius");
  config.drag_amplification = in.number("drag_amplification", config.drag_amplification);
  config.layout = loadFittings(in, p);
  loadUncertainty(in.child("uncertainty"), config.uncertainty);
  // With elements: auto a mesh to begin with, that has room for what is fixed to the tether.
  while (config.accuracy && config.elements < core::MOST_ELEMENTS &&
         !core::validateElementCount(config.elements, p.length, config.layout).empty())
    ++config.elements;
  in.finish();
}

std::optional<core::WinchProperties> loadWinch(ParameterReader in)
{
  core::WinchProperties winch;
  winch.core_diameter = in.number("core_diameter");
  winch.width = in.number("width");
  winch.layers = in.integer("layers");
  in.finish();
  return winch;
}

}  // namespace tether_monitor::params
