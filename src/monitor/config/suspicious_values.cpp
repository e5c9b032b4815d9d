#include "tether_monitor/monitor/config/suspicious_values.h"

#include <algorithm>
#include <cmath>

#include "tether_monitor/core/base/bounds_check.h"

namespace tether_monitor::monitor
{
namespace
{
using core::formatNumber;

constexpr double THICKEST = 0.5;                                      // [m]
constexpr double LIGHTEST = 150.0, HEAVIEST = 20000.0;                // [kg/m^3]
constexpr double SOFTEST = 1e5, STIFFEST = 5e11;                      // EA over the section [Pa]
constexpr double WEAKEST = 2e5;                                       // breaking load over the section [Pa]
constexpr double LIGHTEST_WATER = 900.0, HEAVIEST_WATER = 1300.0;     // [kg/m^3]
constexpr double FASTEST_WATER = 5.0;                                 // [m/s]
constexpr double MOST_DRAG_NORMAL = 5.0, MOST_DRAG_TANGENTIAL = 2.0;  // [-]
constexpr double LIGHTEST_BODY = 50.0, HEAVIEST_BODY = 12000.0;       // [kg/m^3]

void checkProperties(const std::string& prefix, const core::CableProperties& p, std::vector<std::string>& found)
{
  const double density = p.mass_per_length / p.displacedArea();
  if (p.diameter > THICKEST)
    found.push_back(prefix + "diameter = " + formatNumber(p.diameter) + " m: is it in mm?");
  else if (density < LIGHTEST || density > HEAVIEST)
    found.push_back(prefix + "diameter = " + formatNumber(p.diameter) +
                    " m and mass_per_length = " + formatNumber(p.mass_per_length) + " kg/m make a density of " +
                    formatNumber(std::round(10.0 * density) / 10.0) +
                    " kg/m^3: is the mass per km, or the diameter in another unit?");
  const double modulus = p.axial_stiffness / p.displacedArea();
  if (p.diameter <= THICKEST && (modulus < SOFTEST || modulus > STIFFEST))
    found.push_back(prefix + "axial_stiffness = " + formatNumber(p.axial_stiffness) +
                    " N is that of a material of " + formatNumber(modulus) + " Pa: is it in kN?");
  else if (p.axial_stiffness + p.axial_stiffening.largestModulus() < p.breaking_load)
    found.push_back(prefix + "axial_stiffness = " + formatNumber(p.axial_stiffness) +
                    " N is less than breaking_load = " + formatNumber(p.breaking_load) +
                    " N, so it doubles its length before it breaks: is one of them in kN?");
  if (p.diameter <= THICKEST && p.breaking_load / p.displacedArea() < WEAKEST)
    found.push_back(prefix + "breaking_load = " + formatNumber(p.breaking_load) + " N over the section is " +
                    formatNumber(1e-6 * p.breaking_load / p.displacedArea()) + " MPa: is it in kN?");
  if (p.drag_normal > MOST_DRAG_NORMAL)
    found.push_back(prefix + "drag_normal = " + formatNumber(p.drag_normal) + ": a coefficient is near 1");
  if (p.drag_tangential > MOST_DRAG_TANGENTIAL)
    found.push_back(prefix + "drag_tangential = " + formatNumber(p.drag_tangential) +
                    ": a coefficient is below 0.2");
}
}  // namespace

std::vector<std::string> suspiciousValues(const Config& config)
{
  std::vector<std::string> found;
  checkProperties("tether.", config.tether, found);
  for (std::size_t i = 0; i < config.layout.sections.size(); ++i)
    checkProperties("tether.sections[" + std::to_string(i) + "].", config.layout.sections[i].properties, found);
  const double water = config.environment.water_density;
  if (water < LIGHTEST_WATER || water > HEAVIEST_WATER)
    found.push_back("environment.water_density = " + formatNumber(water) + " kg/m^3 is not that of water");
  for (const core::CurrentProfile::Sample& sample : config.environment.current.samples())
    if (sample.velocity.norm() > FASTEST_WATER)
      found.push_back("environment.current: " + formatNumber(sample.velocity.norm()) + " m/s at a depth of " +
                      formatNumber(sample.depth) + " m: is it in cm/s?");
  if (config.vehicle_mode != VehicleMode::TRACKED && config.vehicle_body.volume > 0.0)
  {
    const double density = config.vehicle_body.mass / config.vehicle_body.volume;
    if (density < LIGHTEST_BODY || density > HEAVIEST_BODY)
      found.push_back("vehicle.mass = " + formatNumber(config.vehicle_body.mass) +
                      " kg and vehicle.volume = " + formatNumber(config.vehicle_body.volume) +
                      " m^3 make a density of " + formatNumber(std::round(10.0 * density) / 10.0) +
                      " kg/m^3: is one of them in another unit?");
    if (config.vehicle_body.center_of_buoyancy.z() <= 0.0 && config.vehicle.attachment.z() <= 0.0)
      found.push_back(
          "neither vehicle.center_of_buoyancy (z up) nor vehicle.attachment is above the centre of mass: "
          "nothing rights the vehicle; some centimetres are usual");
  }
  return found;
}

}  // namespace tether_monitor::monitor
