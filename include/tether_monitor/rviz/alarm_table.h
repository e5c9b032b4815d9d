#pragma once

#include <tether_monitor/AlarmArray.h>

#include <QTableWidget>
#include <string>

namespace tether_monitor
{
/// The alarms that are to be seen, gravest first, those that are not acknowledged in bold; advice as tool tips.
class AlarmTable : public QTableWidget
{
 public:
  explicit AlarmTable(QWidget* parent = nullptr);

  /// Shows these; the selection stays with its alarm.
  void show(const AlarmArray& alarms);
  /// Name of the alarm that is selected; empty if none is.
  std::string selected() const;
};

}  // namespace tether_monitor
