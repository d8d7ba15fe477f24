#pragma once
// Work in a process in which no graphics driver has been loaded yet. Drivers read their settings from the
// environment once, so two settings are compared in two processes.

#include <optional>
#include <string>

namespace glibra::bench {

class Apart {
  public:
    /// Forks a process that waits. If this process has more than one thread or has loaded a driver already,
    /// none is forked and nothing is ever answered: a driver's locks would stay locked there.
    Apart();
    Apart(const Apart&) = delete;
    Apart& operator=(const Apart&) = delete;
    ~Apart();

    using Work = std::string (*)(const std::string& request);
    /// What `work` answers to the request, in a new process each time. Nothing if that process crashed or
    /// there is none.
    std::optional<std::string> run(Work work, const std::string& request);

  private:
    int requests_ = -1, answers_ = -1;  ///< ends of two pipes; -1: there is no process
    int process_ = -1;
};

}  // namespace glibra::bench
