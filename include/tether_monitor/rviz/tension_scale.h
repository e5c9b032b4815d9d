#pragma once

#include <QWidget>

namespace tether_monitor
{
/// The colours of the tether in the picture, from no tension to past the working load, with the largest tension
/// and its band on them.
class TensionScale : public QWidget
{
 public:
  explicit TensionScale(QWidget* parent = nullptr);

  /// All in shares of the working load [-]; NaN: not shown.
  struct Reading
  {
    double largest, p05, p95;
  };
  void show(const Reading& reading);
  /// Share of the working load from which there is a warning [-].
  void setWarning(double share);

  static constexpr double END = 1.2;  ///< of the scale [-].

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  int place(double share) const;

  Reading reading_;
  double warning_ = 0.8;
};

}  // namespace tether_monitor
