#include "tether_monitor/ros/alarm_publisher.h"

#include "tether_monitor/ros/alarm_text.h"

namespace tether_monitor
{
static_assert(static_cast<int>(monitor::AlarmState::OUT_OF_SERVICE) == Alarm::OUT_OF_SERVICE,
              "alarm state codes differ");
static_assert(static_cast<int>(monitor::Severity::CRITICAL) == Alarm::CRITICAL, "severity codes differ");

namespace
{
constexpr double PERIOD = 1.0;  // [s]
constexpr int OUTPUT_QUEUE = 10, EVENT_QUEUE = 200;
}  // namespace

Alarm toMessage(const monitor::Alarm& alarm, bool is_first_out, const TimeOrigin& time)
{
  Alarm message;
  const monitor::AlarmDefinition& definition = alarm.definition();
  message.name = definition.name;
  message.state = static_cast<uint8_t>(alarm.state());
  message.severity = static_cast<uint8_t>(definition.severity);
  message.value = alarm.value();
  message.limit = definition.limit;
  message.s = alarm.s();
  message.peak = alarm.peak();
  message.since = time.stamp(alarm.since());
  message.onset = time.stamp(alarm.onset());
  message.shelved_until = time.stamp(alarm.shelvedUntil());
  message.first_out = is_first_out;
  message.chattering = alarm.isChattering();
  message.unit = definition.unit;
  message.text = alarmText(alarm, time);
  message.advice = definition.advice;
  return message;
}

AlarmArray toMessage(const monitor::AlarmSet& set, const TimeOrigin& time)
{
  AlarmArray array;
  for (std::size_t i = 0; i < set.alarms().size(); ++i)
    array.alarms.push_back(toMessage(set.alarms()[i], set.firstOut() == static_cast<int>(i), time));
  return array;
}

AlarmEvent toMessage(const monitor::AlarmEvent& event, const monitor::AlarmSet& set, const TimeOrigin& time)
{
  AlarmEvent message;
  message.header.stamp = time.stamp(event.t);
  message.number = static_cast<std::uint32_t>(event.number);
  message.alarm = toMessage(set.alarms()[event.alarm], event.first_out, time);
  message.alarm.state = static_cast<uint8_t>(event.to);
  message.alarm.value = event.value;
  message.alarm.peak = event.peak;
  message.alarm.s = event.s;
  message.alarm.since = message.header.stamp;
  message.alarm.onset = time.stamp(event.t - event.duration);
  message.alarm.text = eventText(event, set.alarms()[event.alarm].definition());
  message.from = static_cast<uint8_t>(event.from);
  message.to = static_cast<uint8_t>(event.to);
  message.first_out = event.first_out;
  message.duration = event.duration;
  return message;
}

AlarmPublisher::AlarmPublisher(ros::NodeHandle& private_nh)
{
  alarms_ = private_nh.advertise<AlarmArray>("alarms", OUTPUT_QUEUE, true);
  events_ = private_nh.advertise<AlarmEvent>("events", EVENT_QUEUE);
}

void AlarmPublisher::publish(const std_msgs::Header& header, const monitor::AlarmSet& set, const TimeOrigin& time)
{
  const monitor::AlarmLog& log = set.log();
  const bool is_due = secondsBetween(header.stamp, last_) >= PERIOD || header.stamp < last_;
  if (log.last() == last_event_ && !is_due)
    return;
  for (std::size_t i = 0; i < log.events().size(); ++i)
    if (log.events()[i].number > last_event_)
    {
      AlarmEvent event = toMessage(log.events()[i], set, time);
      event.header.frame_id = header.frame_id;
      events_.publish(event);
    }
  last_event_ = log.last();
  AlarmArray array = toMessage(set, time);
  array.header = header;
  alarms_.publish(array);
  last_ = header.stamp;
}

}  // namespace tether_monitor
