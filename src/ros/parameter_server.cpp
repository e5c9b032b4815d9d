#include "tether_monitor/ros/parameter_server.h"

#include <XmlRpcValue.h>

namespace tether_monitor
{
namespace
{
params::Value convert(XmlRpc::XmlRpcValue& value)
{
  using XmlRpc::XmlRpcValue;
  switch (value.getType())
  {
    case XmlRpcValue::TypeBoolean:
      return params::Value(static_cast<bool>(value));
    case XmlRpcValue::TypeInt:
      return params::Value(static_cast<long>(static_cast<int>(value)));
    case XmlRpcValue::TypeDouble:
      return params::Value(static_cast<double>(value));
    case XmlRpcValue::TypeString:
      return params::Value(static_cast<std::string>(value));
    case XmlRpcValue::TypeArray:
    {
      params::Value::List list;
      for (int i = 0; i < value.size(); ++i)
        list.push_back(convert(value[i]));
      return params::Value(std::move(list));
    }
    case XmlRpcValue::TypeStruct:
    {
      params::Value::Map map;
      for (auto& entry : value)
        map.emplace(entry.first, convert(entry.second));
      return params::Value(std::move(map));
    }
    default:
      return params::Value();
  }
}
}  // namespace

params::Value readParameterServer(const ros::NodeHandle& nh)
{
  XmlRpc::XmlRpcValue tree;
  if (!nh.getParam(nh.getNamespace(), tree))
    return params::Value(params::Value::Map{});
  return convert(tree);
}

}  // namespace tether_monitor
