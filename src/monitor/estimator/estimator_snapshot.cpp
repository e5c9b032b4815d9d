#include <algorithm>
#include <cmath>

#include "tether_monitor/core/base/binary_archive.h"
#include "tether_monitor/monitor/config/config_fingerprint.h"
#include "tether_monitor/monitor/estimator/tether_estimator.h"
#include "tether_monitor/monitor/model/model_factory.h"

namespace tether_monitor::monitor
{
namespace
{
const char* const FORMAT = "tether_monitor state 3";

// What stands before the members of an estimator.
struct Header
{
  std::string format = FORMAT;
  std::uint64_t configuration = 0;
  ModelSnapshot model;
  core::MeshSelection mesh;

  template <class Archive>
  void serialize(Archive& a)
  {
    a(format, configuration, model, mesh);
  }
};

// An estimate that the model can be written into.
bool fits(const TetherEstimate& e, const core::CableModel& model)
{
  const std::size_t stations = 2 * static_cast<std::size_t>(model.elements()) + 1;
  const core::StationProfile& f = e.stations;
  for (const std::vector<double>* values : {&f.s, &f.tension, &f.strain, &f.stress, &f.bend_radius})
    if (values->size() != stations)
      return false;
  return f.position.size() == stations && e.contact.obstacles.size() == model.environment().obstacles.size() &&
         e.status >= Status::OK && e.status <= Status::INVALID && std::string(describe(e.reason)) != "unknown";
}
}  // namespace

std::vector<std::uint8_t> TetherEstimator::save() const
{
  TetherEstimator copy = *this;  // an archive takes what it lists by reference
  Header header;
  header.configuration = fingerprint(config_);
  header.model = snapshotOf(model_);
  header.mesh = mesh_;
  core::BinaryWriter writer;
  writer(header, copy);
  std::vector<std::uint8_t> bytes = writer.bytes();
  core::appendChecksum(bytes);
  return bytes;
}

bool TetherEstimator::restore(const std::vector<std::uint8_t>& sealed)
{
  std::vector<std::uint8_t> bytes = sealed;
  if (!core::verifyChecksum(bytes))
    return false;
  Header header;
  core::BinaryReader first(bytes);
  first(header);
  const bool is_mine = first.ok() && header.format == FORMAT && header.configuration == fingerprint(config_) &&
                       std::isfinite(header.mesh.step) && header.mesh.step > 0.0 &&
                       header.mesh.elements == header.model.elements &&
                       (config_.accuracy || header.mesh.elements == config_.elements);
  std::optional<core::CableModel> model = is_mine ? restoreModel(config_, header.model) : std::nullopt;
  if (!model)
    return false;
  TetherEstimator copy = *this;
  first(copy);
  const bool is_sound =
      first.finished() && fits(copy.estimate_, *model) && copy.vessel_.isValid() && copy.vehicle_.isValid() &&
      copy.payout_.isValid() && copy.vessel_filter_.isValid() && copy.observer_.isValid(*model, observer_) &&
      (!copy.settled_ || (isStateOf(copy.state_, *model) && copy.state_.time == copy.estimate_.time));
  if (!is_sound || (copy.told_depth_ && !copy.setDepth(*copy.told_depth_)))
    return false;
  if (copy.told_depth_)
    model->sea().setDepth(*copy.told_depth_);

  // Once more into the members themselves: what they have reserved stays theirs.
  rebuild(std::move(*model), header.mesh);
  core::BinaryReader second(bytes);
  second(header, *this);
  stepper_.prepareObstacles(model_);
  return true;
}

}  // namespace tether_monitor::monitor
