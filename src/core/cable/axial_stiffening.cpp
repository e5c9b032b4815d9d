#include "tether_monitor/core/cable/axial_stiffening.h"

#include <algorithm>
#include <cmath>

namespace tether_monitor::core
{
namespace
{
// Green-Lagrange strain, and the force of the law, at a row.
double greenStrain(const StrainTension& row)
{
  return row.strain + 0.5 * row.strain * row.strain;
}

double lawForce(const StrainTension& row)
{
  return row.tension / (1.0 + row.strain);
}
}  // namespace

double AxialStiffening::force(double eps) const
{
  double sum = 0.0;
  for (int k = 0; k < count; ++k)
    sum += change[k] * std::max(eps - strain[k], 0.0);
  return sum;
}

double AxialStiffening::modulus(double eps) const
{
  double sum = 0.0;
  for (int k = 0; k < count; ++k)
    sum += eps > strain[k] ? change[k] : 0.0;
  return sum;
}

double AxialStiffening::energy(double eps) const
{
  double sum = 0.0;
  for (int k = 0; k < count; ++k)
    sum += 0.5 * change[k] * std::pow(std::max(eps - strain[k], 0.0), 2);
  return sum;
}

double AxialStiffening::largestModulus() const
{
  double sum = 0.0, largest = 0.0;
  for (int k = 0; k < count; ++k)
  {
    sum += change[k];
    largest = std::max(largest, sum);
  }
  return largest;
}

AxialCurve axialCurve(const std::vector<StrainTension>& rows)
{
  AxialCurve curve;
  double strain = 0.0, force = 0.0, stiffness = 0.0;
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    const double next_strain = greenStrain(rows[i]), next_force = lawForce(rows[i]);
    const double next = (next_force - force) / (next_strain - strain);
    if (i == 0)
    {
      curve.stiffness = next;
    }
    else
    {
      curve.stiffening.strain[curve.stiffening.count] = strain;
      curve.stiffening.change[curve.stiffening.count++] = next - stiffness;
    }
    strain = next_strain;
    force = next_force;
    stiffness = next;
  }
  return curve;
}

std::vector<std::string> validate(const std::vector<StrainTension>& rows)
{
  std::vector<std::string> problems;
  if (rows.empty() || rows.size() > AxialStiffening::MOST + 1)
    problems.push_back("a curve of strain and tension has 1 to " + std::to_string(AxialStiffening::MOST + 1) +
                       " rows, not " + std::to_string(rows.size()));
  StrainTension before;
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    const StrainTension& row = rows[i];
    const std::string which = "row " + std::to_string(i + 1) + ": ";
    if (!(std::isfinite(row.strain) && row.strain > before.strain))
      problems.push_back(which + "strain must be greater than " + (i == 0 ? "0" : "in the row before"));
    else if (!(std::isfinite(row.tension) && row.tension > before.tension))
      problems.push_back(which + "tension must be greater than " + (i == 0 ? "0" : "in the row before"));
    else if (!(lawForce(row) > lawForce(before)))
      problems.push_back(which + "tension over (1 + strain) must grow, or the rope gives way");
    else
    {
      before = row;
      continue;
    }
    break;
  }
  return problems;
}

}  // namespace tether_monitor::core
