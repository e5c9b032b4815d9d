#include "tether_monitor/params/attachment_frames.h"

#include "tether_monitor/monitor/config/body_config.h"

namespace tether_monitor::params
{
namespace
{
// A text in a map; nothing if there is none.
const std::string* textAt(const Value::Map& map, const char* key)
{
  const auto found = map.find(key);
  return found == map.end() ? nullptr : found->second.get<std::string>();
}
}  // namespace

std::vector<std::string> placeAttachments(Value& tree, const FrameOrigin& origin)
{
  const auto* all = tree.get<Value::Map>();
  std::vector<std::string> unknown;
  if (!all)
    return unknown;
  Value::Map placed = *all;
  for (const char* name : {"vessel", "vehicle"})
  {
    const auto body = placed.find(name);
    const auto* keys = body == placed.end() ? nullptr : body->second.get<Value::Map>();
    const std::string* frame = keys ? textAt(*keys, "attachment") : nullptr;
    if (!frame)
      continue;
    const std::string* named = textAt(*keys, "frame");
    const std::string body_frame = named ? *named : monitor::BodyConfig().frame;
    if (const auto place = origin(*frame, body_frame))
    {
      Value::Map changed = *keys;
      changed["attachment"] = Value(Value::List{place->x(), place->y(), place->z()});
      body->second = Value(std::move(changed));
    }
    else
    {
      unknown.push_back(std::string(name) + ".attachment = '" + *frame + "': no transform from that frame to '" +
                        body_frame + "'");
    }
  }
  tree = Value(std::move(placed));
  return unknown;
}

}  // namespace tether_monitor::params
