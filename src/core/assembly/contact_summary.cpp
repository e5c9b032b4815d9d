#include "tether_monitor/core/assembly/contact_summary.h"

#include <algorithm>

namespace tether_monitor::core
{
void summarizeContact(const DeployedCable& cable, const CableState& state, ContactSummary& summary)
{
  summary.seabed_length = summary.energy = 0.0;
  summary.touchdown_s = -1.0;
  for (ContactSummary::ObstacleContact& entry : summary.obstacles)
    entry = ContactSummary::ObstacleContact();
  if (!cable.environment().hasContact())
    return;
  const ContactScene scene = cable.contactScene(state);
  for (int i = 0; i < cable.elements(); ++i)
    forContacts(scene, i, TangentWeights{},
                [&](const TetherPoint& at, const ContactResponse& contact, int obstacle)
                {
                  const double s =
                      cable.arcLength(i) + QUADRATURE[at.index - CONTACT_POINTS * i].xi * cable.element(i).length;
                  summary.energy += at.weight * contact.energy;
                  if (obstacle < 0)
                  {
                    summary.seabed_length += at.weight;
                    if (summary.touchdown_s < 0.0)
                      summary.touchdown_s = s;
                    return;
                  }
                  ContactSummary::ObstacleContact& entry = summary.obstacles[obstacle];
                  const double load = at.weight * contact.normal_force;
                  entry.force -= at.weight * contact.force;
                  entry.place += load * at.r;
                  entry.s += load * s;
                  entry.largest = std::max(entry.largest, contact.normal_force);
                  entry.total += load;
                });
  for (ContactSummary::ObstacleContact& entry : summary.obstacles)
    if (entry.total > 0.0)
    {
      entry.place /= entry.total;
      entry.s /= entry.total;
    }
}

}  // namespace tether_monitor::core
