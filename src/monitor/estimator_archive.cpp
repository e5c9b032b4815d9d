#include "tether_monitor/core/archive.h"
#include "tether_monitor/monitor/deployed_model.h"
#include "tether_monitor/monitor/tether_estimator.h"

namespace tether_monitor::monitor
{
namespace
{
const char* const FORMAT = "tether_monitor state 1";

// What stands before the members of an estimator.
struct Header
{
  std::string format = FORMAT;
  double length = 0.0, stiffness = 0.0;  // of the configuration that it belongs to
  ModelMemory model;
  core::MeshChoice mesh;

  template <class Archive>
  void archive(Archive& a)
  {
    a(format, length, stiffness, model, mesh);
  }
};

// A state that the model can be stepped from.
bool fits(const core::CableState& state, const core::CableModel& model)
{
  const std::size_t nodes = model.nodes();
  for (const core::NodeField* field : {&state.q, &state.v, &state.a, &state.aux})
    if (field->size() != nodes)
      return false;
  return state.allFinite() && state.obstacles.size() == model.environment().obstacles.size();
}
}  // namespace

std::vector<std::uint8_t> TetherEstimator::save() const
{
  TetherEstimator copy = *this;  // an archive takes what it lists by reference
  Header header;
  header.length = config_.tether.length;
  header.stiffness = config_.tether.axial_stiffness;
  header.model = memoryOf(model_);
  header.mesh = mesh_;
  core::ArchiveWriter writer;
  writer(header, copy);
  std::vector<std::uint8_t> bytes = writer.bytes();
  core::seal(bytes);
  return bytes;
}

bool TetherEstimator::restore(const std::vector<std::uint8_t>& sealed)
{
  std::vector<std::uint8_t> bytes = sealed;
  if (!core::unseal(bytes))
    return false;
  Header header;
  core::ArchiveReader first(bytes);
  first(header);
  if (!first.ok() || header.format != FORMAT || header.length != config_.tether.length ||
      header.stiffness != config_.tether.axial_stiffness || !(header.mesh.step > 0.0) ||
      header.mesh.elements != header.model.elements)
    return false;
  std::optional<core::CableModel> model = modelFrom(config_, header.model);
  if (!model)
    return false;
  TetherEstimator copy = *this;
  first(copy);
  if (!first.finished() || (copy.settled_ && !fits(copy.state_, *model)))
    return false;

  // Once more into the members themselves: what they have reserved stays theirs.
  rebuild(std::move(*model), header.mesh);
  core::ArchiveReader second(bytes);
  second(header, *this);
  if (told_depth_)
    model_.sea().setDepth(*told_depth_);
  stepper_.prepareObstacles(model_);
  return true;
}

}  // namespace tether_monitor::monitor
