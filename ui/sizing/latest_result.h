// Work on another thread that follows what a person types: asked again and again, it waits until
// typing pauses, works once at a time, and shows only a result that is still wanted.
#pragma once

#include <QFutureWatcher>
#include <QPromise>
#include <QThreadPool>
#include <QTimer>
#include <functional>
#include <memory>

namespace rotorbench {

template <class Result>
class LatestResult {
 public:
  using Job = std::function<Result()>;

  /// `prepare` takes what the job needs, on this thread; the job itself runs on another one and
  /// must not throw; `show` gets the result on this thread again.
  LatestResult(std::function<Job()> prepare, std::function<void(const Result&)> show)
      : prepare_(std::move(prepare)), show_(std::move(show)) {
    constexpr int kPause = 60;  // ms
    timer_.setSingleShot(true);
    timer_.setInterval(kPause);
    QObject::connect(&timer_, &QTimer::timeout, &timer_, [this] { begin(); });
    QObject::connect(&watcher_, &QFutureWatcherBase::finished, &timer_, [this] { end(); });
  }
  ~LatestResult() {
    watcher_.disconnect();
    watcher_.waitForFinished();
  }
  LatestResult(const LatestResult&) = delete;
  LatestResult& operator=(const LatestResult&) = delete;

  void ask() { timer_.start(); }

 private:
  void begin() {
    if (watcher_.isRunning()) {
      again_ = true;
      return;
    }
    again_ = false;
    auto promise = std::make_shared<QPromise<Result>>();
    watcher_.setFuture(promise->future());
    promise->start();
    QThreadPool::globalInstance()->start([promise, job = prepare_()] {
      promise->addResult(job());
      promise->finish();
    });
  }
  void end() {
    if (again_) return begin();
    show_(watcher_.result());
  }

  std::function<Job()> prepare_;
  std::function<void(const Result&)> show_;
  QTimer timer_;
  QFutureWatcher<Result> watcher_;
  bool again_ = false;
};

}  // namespace rotorbench
