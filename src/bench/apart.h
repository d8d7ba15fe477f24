#pragma once
// Work in a process in which no graphics driver has been loaded yet. Drivers read their settings from the
// environment once, so two settings are compared in two processes.

#include <optional>
#include <string>

namespace glibra::bench {

class Apart {
  public:
    /// Forks a process that waits. It must be made before this process loads a driver or starts a thread;
    /// made later, its work meets the driver as this process has set it up.
    Apart();
    Apart(const Apart&) = delete;
    Apart& operator=(const Apart&) = delete;
    ~Apart();

    using Work = std::string (*)(const std::string& request);
    /// What `work` answers to the request, in a new process each time. Nothing if that process crashed or
    /// could not be made.
    std::optional<std::string> run(Work work, const std::string& request);

  private:
    int requests_ = -1, answers_ = -1;  ///< ends of two pipes; -1: there is no process
    int process_ = -1;
};

}  // namespace glibra::bench
