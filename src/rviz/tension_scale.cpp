#include "tether_monitor/rviz/tension_scale.h"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <limits>

#include "tether_monitor/ros/markers.h"

namespace tether_monitor
{
namespace
{
constexpr int HEIGHT = 56, BAR_TOP = 14, BAR_HEIGHT = 16, MARGIN = 24, LABEL_WIDTH = 46;  // [pixels]
constexpr double NONE = std::numeric_limits<double>::quiet_NaN();
}  // namespace

TensionScale::TensionScale(QWidget* parent) : QWidget(parent), reading_{NONE, NONE, NONE}
{
  setFixedHeight(HEIGHT);
  setToolTip("Colours of the tether: tension over the working load");
}

void TensionScale::show(const Reading& reading)
{
  reading_ = reading;
  update();
}

void TensionScale::setWarning(double share)
{
  warning_ = share;
  update();
}

int TensionScale::place(double share) const
{
  return MARGIN + static_cast<int>(std::lround(std::clamp(share / END, 0.0, 1.0) * (width() - 2 * MARGIN)));
}

void TensionScale::paintEvent(QPaintEvent* /*event*/)
{
  QPainter painter(this);
  for (int x = MARGIN; x < width() - MARGIN; ++x)
  {
    const double share = END * (x - MARGIN) / std::max(width() - 2 * MARGIN, 1);
    const std_msgs::ColorRGBA colour = utilisationColour(share, warning_);
    painter.fillRect(x, BAR_TOP, 1, BAR_HEIGHT, QColor::fromRgbF(colour.r, colour.g, colour.b));
  }
  painter.setPen(palette().color(QPalette::WindowText));
  for (const double share : {0.0, warning_, 1.0})
  {
    const int x = place(share);
    painter.drawLine(x, BAR_TOP + BAR_HEIGHT, x, BAR_TOP + BAR_HEIGHT + 4);
    painter.drawText(QRect(x - LABEL_WIDTH / 2, BAR_TOP + BAR_HEIGHT + 4, LABEL_WIDTH, 18), Qt::AlignHCenter,
                     QString("%1 %").arg(100.0 * share));
  }
  if (!std::isfinite(reading_.largest))
    return;
  if (std::isfinite(reading_.p05) && std::isfinite(reading_.p95))
    painter.fillRect(QRect(QPoint(place(reading_.p05), BAR_TOP - 4), QPoint(place(reading_.p95), BAR_TOP - 2)),
                     palette().color(QPalette::WindowText));
  const int x = place(reading_.largest);
  QPolygon pointer;
  pointer << QPoint(x, BAR_TOP) << QPoint(x - 5, 2) << QPoint(x + 5, 2);
  painter.setBrush(palette().color(QPalette::WindowText));
  painter.drawPolygon(pointer);
}

}  // namespace tether_monitor
