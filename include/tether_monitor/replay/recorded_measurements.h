#pragma once

#include <optional>
#include <vector>

#include "tether_monitor/files/csv_table.h"
#include "tether_monitor/monitor/estimator/tether_estimator.h"

namespace tether_monitor::replay
{
/// What came in at one time; an empty field is no measurement.
struct MeasurementRow
{
  double t = 0.0;  ///< [s]
  std::optional<monitor::PoseMeasurement> vessel, vehicle;
  std::optional<monitor::TwistMeasurement> vessel_rates, vehicle_rates;
  std::optional<double> tension;           ///< of the load cell [N].
  std::optional<core::Vector3> direction;  ///< in which the tether leaves the vessel, any length.
};

/// Measured motion of vessel and vehicle, row by row, for mode observed.
class RecordedMeasurements
{
 public:
  /**
   * @param table  read with mayBeEmpty(). Columns: t, vessel_x..z, vehicle_x..z; optional vessel_vx..vz,
   * vehicle_vx..vz, vessel_qx..qw, vehicle_qx..qw, vessel_stddev, vehicle_stddev [m], tension [N],
   * direction_x..z. A row whose vessel_x and
   * vessel_y are empty measures the height alone; of the vehicle every empty field is an axis that was not
   * measured.
   * @throws std::runtime_error naming file and line or column: unknown or missing column, t that does not
   * increase, no row, a measurement with a part missing, a standard deviation that is not > 0, a bad quaternion.
   */
  explicit RecordedMeasurements(const files::CsvTable& table);

  const std::vector<MeasurementRow>& rows() const { return rows_; }
  /// Position and velocity of the vessel at the first row; none if its velocity is not measured there.
  std::optional<monitor::BodyState> vesselAtFirstRow() const;

 private:
  std::vector<MeasurementRow> rows_;
};

/// True for the columns of a body and of the sensors at the vessel end: their fields may be empty.
bool mayBeEmpty(const std::string& column);

}  // namespace tether_monitor::replay
