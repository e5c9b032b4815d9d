#include "tether_monitor/replay/result_files.h"

#include <cmath>

namespace tether_monitor::replay
{
using monitor::TetherEstimate;

namespace
{
const char* header(VehicleColumns vehicle)
{
  switch (vehicle)
  {
    case VehicleColumns::RELATIVE:
      return ",vehicle_x,vehicle_y,vehicle_z";
    case VehicleColumns::POSE:
      return ",vehicle_x,vehicle_y,vehicle_z,vehicle_qx,vehicle_qy,vehicle_qz,vehicle_qw";
    case VehicleColumns::OBSERVED:
      return ",vehicle_x,vehicle_y,vehicle_z,vehicle_qx,vehicle_qy,vehicle_qz,vehicle_qw,vessel_tension_stddev,"
             "vehicle_tension_stddev,vehicle_position_stddev,vessel_tension_p05,vessel_tension_p95,vehicle_"
             "tension_p05,"
             "vehicle_tension_p95";
    case VehicleColumns::NONE:
      break;
  }
  return "";
}
}  // namespace

EndsFile::EndsFile(const std::string& folder, VehicleColumns vehicle)
  : vehicle_(vehicle),
    csv_(folder + "/ends.csv",
         std::string("t,vessel_fx,vessel_fy,vessel_fz,vehicle_fx,vehicle_fy,vehicle_fz,max_tension,max_tension_s,"
                     "stretched_length,status") +
             header(vehicle))
{
}

void EndsFile::write(const TetherEstimate& e)
{
  constexpr double NONE = TetherEstimate::NONE;
  csv_.time(e.time);
  for (const core::Vector3& force : {e.stations.ends.vessel, e.stations.ends.vehicle})
    for (int i = 0; i < 3; ++i)
      csv_.number(e.has_stations ? force[i] : NONE);
  csv_.number(e.max_tension).number(e.max_tension_s);
  csv_.number(e.has_stations ? e.stations.stretched_length : NONE);
  csv_.text(describe(e.status));
  if (vehicle_ == VehicleColumns::RELATIVE)
  {
    const core::Vector3 chord = e.has_stations
                                    ? core::Vector3(e.stations.position.back() - e.stations.position.front())
                                    : core::Vector3::Constant(NONE);
    csv_.number(chord.x()).number(chord.y()).number(chord.z());
  }
  if (vehicle_ == VehicleColumns::POSE || vehicle_ == VehicleColumns::OBSERVED)
  {
    for (int i = 0; i < 3; ++i)
      csv_.number(e.has_vehicle ? e.vehicle.position[i] : NONE);
    for (int i = 0; i < 4; ++i)
      csv_.number(e.has_vehicle ? e.vehicle.orientation.coeffs()[i] : NONE);
  }
  if (vehicle_ == VehicleColumns::OBSERVED)
    for (const double x :
         {e.vessel_tension_stddev, e.vehicle_tension_stddev, e.vehicle_position_stddev, e.vessel_tension_p05,
          e.vessel_tension_p95, e.vehicle_tension_p05, e.vehicle_tension_p95})
      csv_.number(x);
  csv_.endRow();
}

ParametersFile::ParametersFile(const std::string& folder)
  : csv_(folder + "/parameters.csv", "t,name,mean,stddev,configured,configured_stddev")
{
}

void ParametersFile::write(double t, const std::vector<monitor::ParameterEstimate>& parameters)
{
  for (const monitor::ParameterEstimate& p : parameters)
    csv_.time(t)
        .text(p.name)
        .number(p.mean)
        .number(p.stddev)
        .number(p.configured)
        .number(p.configured_stddev)
        .endRow();
}

ContactsFile::ContactsFile(const std::string& folder)
  : csv_(folder + "/contacts.csv", "t,obstacle,fx,fy,fz,x,y,z,s")
{
}

void ContactsFile::write(const TetherEstimate& e, const std::vector<core::Obstacle>& obstacles)
{
  for (std::size_t k = 0; k < obstacles.size() && k < e.contact.obstacles.size(); ++k)
  {
    const core::ContactSummary::ObstacleContact& touch = e.contact.obstacles[k];
    if (!(touch.total > 0.0))
      continue;
    csv_.time(e.time).text(obstacles[k].name);
    for (const core::Vector3& v : {touch.force, touch.place})
      csv_.number(v.x()).number(v.y()).number(v.z());
    csv_.number(touch.s).endRow();
  }
}

ShapeFile::ShapeFile(const std::string& folder)
  : csv_(folder + "/shape.csv", "t,s,x,y,z,tension,strain,bend_radius,stress")
{
}

void ShapeFile::write(const TetherEstimate& e)
{
  if (!e.has_stations)
    return;
  const core::StationProfile& at = e.stations;
  for (std::size_t i = 0; i < at.s.size(); ++i)
  {
    csv_.time(e.time)
        .number(at.s[i])
        .number(at.position[i].x())
        .number(at.position[i].y())
        .number(at.position[i].z());
    csv_.number(at.tension[i]).number(at.strain[i]).number(at.bend_radius[i]).number(at.stress[i]).endRow();
  }
}

void writeModes(const std::string& folder, const std::vector<core::Mode>& modes, const std::vector<double>& node_s)
{
  files::CsvWriter frequencies(folder + "/modes.csv", "mode,kind,frequency_hz");
  files::CsvWriter shapes(folder + "/mode_shapes.csv", "mode,s,dx,dy,dz");
  for (std::size_t k = 0; k < modes.size(); ++k)
  {
    const double number = static_cast<double>(k + 1);
    frequencies.number(number)
        .text(modes[k].kind == core::ModeKind::AXIAL ? "axial" : "transverse")
        .number(modes[k].frequency)
        .endRow();
    for (std::size_t i = 0; i < node_s.size(); ++i)
      shapes.number(number)
          .number(node_s[i])
          .number(modes[k].shape[i][0])
          .number(modes[k].shape[i][1])
          .number(modes[k].shape[i][2])
          .endRow();
  }
  frequencies.close();
  shapes.close();
}

AlarmsFile::AlarmsFile(const std::string& folder)
  : csv_(folder + "/alarms.csv", "t,name,state,severity,value,limit,s")
{
}

void AlarmsFile::write(double t, const monitor::AlarmSet& set)
{
  last_.resize(set.alarms().size(), monitor::AlarmState::NORMAL);
  for (std::size_t i = 0; i < last_.size(); ++i)
  {
    const monitor::Alarm& alarm = set.alarms()[i];
    if (alarm.state() == last_[i])
      continue;
    last_[i] = alarm.state();
    csv_.time(t)
        .text(alarm.definition().name)
        .text(constantName(alarm.state()))
        .text(describe(alarm.definition().severity));
    csv_.number(alarm.value()).number(alarm.definition().limit).number(alarm.s()).endRow();
  }
}

const char* describe(monitor::Severity severity)
{
  switch (severity)
  {
    case monitor::Severity::WARNING:
      return "WARNING";
    case monitor::Severity::ALARM:
      return "ALARM";
    case monitor::Severity::CRITICAL:
      return "CRITICAL";
  }
  return "UNKNOWN";
}

}  // namespace tether_monitor::replay
