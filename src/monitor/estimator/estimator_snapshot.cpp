#include "tether_monitor/monitor/estimator/estimator_snapshot.h"

#include <cmath>
#include <optional>
#include <string>

#include "tether_monitor/core/base/binary_archive.h"
#include "tether_monitor/monitor/config/config_fingerprint.h"
#include "tether_monitor/monitor/model/model_factory.h"

namespace tether_monitor::monitor
{
namespace
{
const char* const FORMAT = "tether_monitor state 18";

// What has become of a model since it was made of the configuration.
struct ModelChanges
{
  double built_length = 0.0;  // [m]
  core::MeshSelection mesh;
  std::optional<MeshPurpose> mesh_purpose;
  std::vector<core::CurrentProfile::Sample> current;
  std::vector<core::Obstacle> obstacles;
  std::optional<double> depth;  // [m]
  double time_origin = 0.0;     // [s]
  core::Vector3 origin = core::Vector3::Zero();

  template <class Archive>
  void serialize(Archive& a)
  {
    a(built_length, mesh, mesh_purpose, current, obstacles, depth, time_origin, origin);
  }
};

// What stands before the members of an estimator.
struct Header
{
  std::string format = FORMAT;
  std::uint64_t configuration = 0;
  ModelChanges model;

  template <class Archive>
  void serialize(Archive& a)
  {
    a(format, configuration, model);
  }
};

ModelChanges changesOf(const CableSimulation& simulation)
{
  const core::EnvironmentModel& sea = simulation.model.environment();
  return {simulation.model.length(), simulation.mesh,           simulation.mesh_purpose, sea.current().samples(),
          sea.obstacles(),           simulation.reported_depth, sea.timeOrigin(),        simulation.origin()};
}

bool arePossible(const ModelChanges& changes, const Config& config)
{
  bool are = std::isfinite(changes.mesh.step) && changes.mesh.step > 0.0 &&
             (config.accuracy || changes.mesh.elements == config.elements) &&
             canMesh(config, changes.built_length, changes.mesh.elements) && std::isfinite(changes.time_origin) &&
             changes.origin.allFinite() && core::validate(changes.current).empty();
  for (const core::Obstacle& obstacle : changes.obstacles)
    are = are && core::validate(obstacle, "").empty();
  return are;
}

std::optional<core::CableModel> makeModel(const Config& config, const ModelChanges& changes)
{
  if (!arePossible(changes, config))
    return std::nullopt;
  core::Environment sea = config.environment;
  sea.current = core::CurrentProfile(changes.current);
  sea.obstacles = changes.obstacles;
  if (changes.depth && !sea.seabed)
    return std::nullopt;
  if (changes.depth)
    sea.seabed->depth = *changes.depth;
  if (!core::validate(sea).empty())
    return std::nullopt;
  core::EnvironmentModel environment =
      core::EnvironmentModel(sea).withOrigin(changes.origin).withTimeOrigin(changes.time_origin);
  if (changes.depth)
    environment = environment.withDepth(*changes.depth);
  return makeModel(config, changes.built_length, changes.mesh.elements).withEnvironment(environment);
}

// An estimate that the model can be written into.
bool fits(const TetherEstimate& e, const core::CableModel& model)
{
  const std::size_t stations = 2 * static_cast<std::size_t>(model.elements()) + 1;
  const core::StationProfile& f = e.stations;
  for (const std::vector<double>* values : {&f.s, &f.tension, &f.strain, &f.stress, &f.bend_radius})
    if (values->size() != stations)
      return false;
  return f.position.size() == stations && e.contact.obstacles.size() == model.environment().obstacles().size() &&
         e.status >= Status::OK && e.status <= Status::STOWED && std::string(describe(e.reason)) != "UNKNOWN";
}

void setModel(const core::CableModel& model, const ModelChanges& changes, CableSimulation& simulation)
{
  simulation.setModel(model, changes.mesh);
  simulation.mesh_purpose = changes.mesh_purpose;
  simulation.reported_depth = changes.depth;
}
}  // namespace

std::vector<std::uint8_t> EstimatorSnapshot::save(const TetherEstimator& estimator)
{
  Header header;
  header.configuration = fingerprint(estimator.config_);
  header.model = changesOf(estimator.cycle_.simulation_);
  core::BinaryWriter writer;
  writer(header, estimator);
  std::vector<std::uint8_t> bytes = writer.bytes();
  core::appendChecksum(bytes);
  return bytes;
}

bool EstimatorSnapshot::restore(const std::vector<std::uint8_t>& sealed, TetherEstimator& estimator)
{
  return restore(sealed, fingerprint(estimator.config_), estimator);
}

bool EstimatorSnapshot::carryOver(const TetherEstimator& from, TetherEstimator& to)
{
  return restore(save(from), fingerprint(from.config_), to);
}

bool EstimatorSnapshot::restore(const std::vector<std::uint8_t>& sealed, std::uint64_t configuration,
                                TetherEstimator& estimator)
{
  std::vector<std::uint8_t> bytes = sealed;
  if (!core::verifyChecksum(bytes))
    return false;
  Header header;
  core::BinaryReader reader(bytes);
  reader(header);
  if (!reader.ok() || header.format != FORMAT || header.configuration != configuration)
    return false;
  const std::optional<core::CableModel> model = makeModel(estimator.config_, header.model);
  if (!model)
    return false;
  TetherEstimator copy = estimator;
  setModel(*model, header.model, copy.cycle_.simulation_);
  copy.cycle_.vehicle_->prepare(*model);
  reader(copy);
  const core::CableState& state = copy.cycle_.simulation_.state;
  const bool is_sound = reader.finished() && fits(copy.estimate(), *model) && copy.phase() >= Phase::IDLE &&
                        copy.phase() <= Phase::RUNNING && copy.cycle_.vessel_->isValid() &&
                        copy.cycle_.vehicle_->isValid(*model) && copy.forecast_inputs_.isValid() &&
                        copy.alarms_.isValid() && copy.alarm_inputs_.isValid() && copy.cycle_.payout_.isValid() &&
                        (!copy.isRunning() || (isStateOf(state, *model) && state.time == copy.estimate().time));
  if (!is_sound)
    return false;

  // Once more into the members themselves: what they have reserved stays theirs.
  setModel(*model, header.model, estimator.cycle_.simulation_);
  estimator.cycle_.vehicle_->prepare(*model);
  core::BinaryReader again(bytes);
  again(header, estimator);
  estimator.cycle_.simulation_.stepper.prepareObstacles(*model);
  return true;
}

}  // namespace tether_monitor::monitor
