#include "verification/manoeuvres.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace tether_monitor::bench
{
namespace
{
using core::EndMotion;
using core::Vector3;
using Generator = std::mt19937;

constexpr double BEGIN = MANOEUVRE_BEGINS;

double between(Generator& generator, double low, double high)
{
  return std::uniform_real_distribution<double>(low, high)(generator);
}

// From one value to another within `ramp` seconds from BEGIN on.
double ramped(double t, double from, double to, double ramp)
{
  return from + (to - from) * std::clamp((t - BEGIN) / ramp, 0.0, 1.0);
}

// Integral of that.
double integralOfRamped(double t, double from, double to, double ramp)
{
  const double since = std::clamp(t - BEGIN, 0.0, ramp);
  return from * t + (to - from) * (0.5 * since * since / ramp + std::max(t - BEGIN - ramp, 0.0));
}

double heaveAt(double t, double amplitude)
{
  constexpr double PERIOD = 8.0, GENTLY = 16.0;
  return std::min(t / GENTLY, 1.0) * amplitude * std::sin(2.0 * M_PI * t / PERIOD);
}

UncertainCase tow(double speed, const std::function<Vector3(double)>& vessel)
{
  UncertainCase c = uncertainCase("C");
  c.true_elements = 50;
  c.of.duration = MANOEUVRE_DURATION;
  c.of.start.velocity = {speed, 0.0, 0.0};
  c.of.vessel = [vessel](double t) { return EndMotion{vessel(t) - 5.0 * Vector3::UnitZ(), Vector3::Zero()}; };
  return c;
}

UncertainCase speedsUp(Generator& generator)
{
  const double from = between(generator, 1.5, 2.5), to = from + between(generator, 0.2, 1.5);
  const double ramp = between(generator, 15.0, 60.0);
  return tow(from, [=](double t) { return Vector3(integralOfRamped(t, from, to, ramp), 0.0, heaveAt(t, 0.4)); });
}

UncertainCase heaves(Generator& generator)
{
  const double speed = between(generator, 1.5, 2.5), height = between(generator, 0.6, 3.0);
  const double ramp = between(generator, 20.0, 60.0);
  return tow(speed, [=](double t) { return Vector3(speed * t, 0.0, heaveAt(t, ramped(t, 0.4, height, ramp))); });
}

// A turn that begins at once and ends; places by adding up small steps.
UncertainCase straightens(Generator& generator)
{
  constexpr double STEP = 0.01, GENTLY = 15.0;
  const double speed = between(generator, 1.5, 2.5), rate = between(generator, 0.01, 0.04);
  const double ramp = between(generator, 5.0, 20.0);
  auto places = std::make_shared<std::vector<Vector3>>();
  Vector3 place = Vector3::Zero();
  double heading = 0.0;
  for (double t = 0.0; t < MANOEUVRE_DURATION + 1.0; t += STEP)
  {
    places->push_back(place);
    heading += STEP * rate * std::min(t / GENTLY, 1.0) * (1.0 - ramped(t, 0.0, 1.0, ramp));
    place += STEP * speed * Vector3(std::cos(heading), std::sin(heading), 0.0);
  }
  return tow(speed,
             [=](double t)
             {
               const auto k = std::min(static_cast<std::size_t>(t / STEP), places->size() - 2);
               const double share = t / STEP - static_cast<double>(k);
               const Vector3 at = (1.0 - share) * (*places)[k] + share * (*places)[k + 1];
               return Vector3(at.x(), at.y(), heaveAt(t, 0.4));
             });
}

UncertainCase winchStops(Generator& generator)
{
  constexpr double GENTLY = 20.0;
  const double speed = between(generator, 1.5, 2.5), rate = between(generator, 0.3, 0.9);
  const double ramp = between(generator, 1.0, 5.0);
  UncertainCase c = tow(speed, [=](double t) { return Vector3(speed * t, 0.0, heaveAt(t, 0.4)); });
  const double deployed = c.of.tether.length;
  c.payout = [=](double t)
  {
    const double begun = std::min(t / GENTLY, 1.0);
    const double paid_out =
        integralOfRamped(t, rate, 0.0, ramp) - rate * (std::min(t, GENTLY) - 0.5 * GENTLY * begun * begun);
    return core::PayoutState{deployed + paid_out, begun * ramped(t, rate, 0.0, ramp), 0.0};
  };
  return c;
}

// A vehicle at its station; its thrust is reported.
UncertainCase station(double vessel_speed, double ramp)
{
  UncertainCase c = uncertainCase("G");
  c.reports_thrust = true;
  c.force_stddev = 40.0;
  c.most_thrust = 900.0;
  c.of.duration = MANOEUVRE_DURATION;
  const auto drifting = c.of.vessel;
  c.of.vessel = [=](double t)
  {
    EndMotion end = drifting(t);
    end.position.x() -= integralOfRamped(t, 0.0, vessel_speed, ramp);
    return end;
  };
  return c;
}

UncertainCase pullsAway(Generator& generator)
{
  UncertainCase c = station(0.0, 1.0);
  c.changes_at = BEGIN;
  c.push = between(generator, 150.0, 900.0);
  return c;
}

UncertainCase setsOff(Generator& generator)
{
  const double speed = between(generator, 0.3, 1.2);
  return station(speed, between(generator, 5.0, 20.0));
}
}  // namespace

std::vector<Manoeuvre> manoeuvres()
{
  return {{"a tow speeds up by 0.2 to 1.5 m/s", 2.0, speedsUp},
          {"the heave of a tow grows to 0.6 to 3 m", 2.0, heaves},
          {"a tow comes out of a turn", 1.5, straightens},
          {"the winch of a tow stops", 1.6, winchStops},
          {"a vehicle pulls away with 150 to 900 N", 4.0, pullsAway},
          {"the vessel sets off at 0.3 to 1.2 m/s", 4.0, setsOff}};
}

}  // namespace tether_monitor::bench
