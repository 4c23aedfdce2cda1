#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace offing {

/// First and last second that the demo knows: 1600-01-01 00:00:00 and 2200-12-31 23:59:59 UTC,
/// since 1970-01-01 in the Gregorian calendar.
double first_utc_seconds();
double last_utc_seconds();

/// "2026-06-21" as seconds at its midnight. Empty where `problem` (if given) says why not:
/// "must be YYYY-MM-DD, as 2026-06-21", "2026-02 has 28 days", "must be 1600 to 2200".
std::optional<double> parse_date(std::string_view text, std::string* problem = nullptr);

/// "18:30" or "18:30:15" as seconds since midnight.
std::optional<double> parse_time(std::string_view text, std::string* problem = nullptr);

/// "2026-06-21" and "18:30:00" (seconds cut, not rounded).
std::string date_text(double utc_seconds);
std::string time_text(double utc_seconds);

}  // namespace offing
