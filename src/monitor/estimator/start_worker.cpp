#include "tether_monitor/monitor/estimator/start_worker.h"

#include <utility>

namespace tether_monitor::monitor
{
StartWorker& StartWorker::operator=(const StartWorker& other)
{
  if (this != &other)
    end();
  return *this;
}

StartWorker& StartWorker::operator=(StartWorker&& other) noexcept
{
  if (this == &other)
    return *this;
  end();
  job_ = std::move(other.job_);
  return *this;
}

StartWorker::~StartWorker()
{
  end();
}

void StartWorker::end()
{
  if (job_ && job_->thread.joinable())
    job_->thread.join();
  job_.reset();
}

void StartWorker::search(const Config& config, const CableSimulation& simulation,
                         const std::vector<core::Obstacle>& obstacles, const VehicleEnd& vehicle, double t,
                         const EndTargets& targets)
{
  job_.reset(new Job{config, obstacles, vehicle.clone(), t, targets, {simulation, {}, {}}});
  job_->thread = std::thread(
      [job = job_.get()]
      {
        try
        {
          job->found = findSteadyStart(job->config, job->found.simulation, job->obstacles, *job->vehicle, job->t,
                                       job->targets);
        }
        catch (const std::exception&)
        {
          job->found.is_found = false;  // out of memory: as if there were none
        }
        job->is_done = true;
      });
}

SteadyStart StartWorker::take(double& t, EndTargets& targets)
{
  t = job_->t;
  targets = job_->targets;
  job_->thread.join();
  SteadyStart found = std::move(job_->found);
  job_.reset();
  return found;
}

void StartWorker::discard()
{
  if (job_)
    job_->is_discarded = true;
  collect();
}

void StartWorker::collect()
{
  if (job_ && job_->is_discarded && job_->is_done)
    end();
}

}  // namespace tether_monitor::monitor
