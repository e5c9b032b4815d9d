#include "tether_monitor/rviz/alarm_table.h"

#include <QHeaderView>
#include <algorithm>
#include <vector>

#include "tether_monitor/rviz/panel_text.h"

namespace tether_monitor
{
namespace
{
constexpr int NAME = 0, STATE = 1, VALUE = 2, PEAK = 3, COLUMNS = 4;

QColor colourOf(const Alarm& alarm)
{
  if (alarm.severity == Alarm::WARNING)
    return {240, 228, 66};
  return alarm.severity == Alarm::ALARM ? QColor(230, 159, 0) : QColor(213, 94, 0);
}

// Gravest first, then what came first.
bool isBefore(const Alarm& a, const Alarm& b)
{
  return a.severity != b.severity ? a.severity > b.severity : a.onset < b.onset;
}
}  // namespace

AlarmTable::AlarmTable(QWidget* parent) : QTableWidget(0, COLUMNS, parent)
{
  setHorizontalHeaderLabels({"alarm", "state", "value", "peak"});
  verticalHeader()->hide();
  horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  horizontalHeader()->setSectionResizeMode(NAME, QHeaderView::Stretch);  // a long name wraps, figures are whole
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setEditTriggers(QAbstractItemView::NoEditTriggers);
  setSelectionBehavior(QAbstractItemView::SelectRows);
  setSelectionMode(QAbstractItemView::SingleSelection);
}

void AlarmTable::show(const AlarmArray& alarms)
{
  const std::string before = selected();
  std::vector<Alarm> shown;
  std::copy_if(alarms.alarms.begin(), alarms.alarms.end(), std::back_inserter(shown), isShown);
  std::stable_sort(shown.begin(), shown.end(), isBefore);
  setRowCount(static_cast<int>(shown.size()));
  clearSelection();
  for (int row = 0; row < rowCount(); ++row)
  {
    const Alarm& alarm = shown[static_cast<std::size_t>(row)];
    const QString texts[COLUMNS] = {
        QString::fromStdString(alarm.name).replace('_', ' ') + (alarm.first_out ? " (first)" : ""),
        QString::fromStdString(alarmStateText(alarm)),
        QString::fromStdString(alarmValueText(alarm.value, alarm.unit)),
        QString::fromStdString(alarmValueText(alarm.peak, alarm.unit))};
    for (int column = 0; column < COLUMNS; ++column)
    {
      auto* item = new QTableWidgetItem(texts[column]);  // the table owns it
      item->setData(Qt::UserRole, QString::fromStdString(alarm.name));
      item->setToolTip(QString::fromStdString(alarm.text + "\n" + alarm.advice));
      item->setBackground(colourOf(alarm));
      item->setForeground(Qt::black);
      QFont font = item->font();
      font.setBold(alarm.state == Alarm::UNACKNOWLEDGED || alarm.state == Alarm::RETURNED_UNACKNOWLEDGED);
      item->setFont(font);
      setItem(row, column, item);
    }
    if (alarm.name == before)
      selectRow(row);
  }
  resizeRowsToContents();
}

std::string AlarmTable::selected() const
{
  const QList<QTableWidgetItem*> items = selectedItems();
  return items.isEmpty() ? "" : items.front()->data(Qt::UserRole).toString().toStdString();
}

}  // namespace tether_monitor
