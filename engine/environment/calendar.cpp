#include "engine/environment/calendar.h"

#include <fmt/core.h>

#include <chrono>
#include <cmath>

namespace offing {
namespace {

namespace chrono = std::chrono;

constexpr double kDay = 86400.0;
constexpr int kFirstYear = 1600, kLastYear = 2200;

/// The digits text[first, first + count) as a number; -1 where one is no digit.
int digits(std::string_view text, std::size_t first, std::size_t count) {
  int value = 0;
  for (char c : text.substr(first, count)) {
    if (c < '0' || c > '9') return -1;
    value = 10 * value + (c - '0');
  }
  return value;
}

double days_since_1970(chrono::year_month_day date) {
  return static_cast<double>(chrono::sys_days(date).time_since_epoch().count());
}

template <class... Args>
std::nullopt_t refuse(std::string* problem, fmt::format_string<Args...> format, Args&&... args) {
  if (problem) *problem = fmt::format(format, std::forward<Args>(args)...);
  return std::nullopt;
}

}  // namespace

double first_utc_seconds() {
  return kDay * days_since_1970(chrono::year(kFirstYear) / chrono::January / 1);
}

double last_utc_seconds() {
  return kDay * days_since_1970(chrono::year(kLastYear + 1) / chrono::January / 1) - 1.0;
}

std::optional<double> parse_date(std::string_view text, std::string* problem) {
  const bool shape = text.size() == 10 && text[4] == '-' && text[7] == '-';
  const int year = shape ? digits(text, 0, 4) : -1;
  const int month = shape ? digits(text, 5, 2) : -1;
  const int day = shape ? digits(text, 8, 2) : -1;
  if (year < 0 || month < 0 || day < 0) {
    return refuse(problem, "must be YYYY-MM-DD, as 2026-06-21");
  }
  if (year < kFirstYear || year > kLastYear) {
    return refuse(problem, "must be a date from {} to {}", kFirstYear, kLastYear);
  }
  if (month < 1 || month > 12) return refuse(problem, "must have a month from 01 to 12");
  const chrono::year_month_day_last last{
      chrono::year(year), chrono::month_day_last(chrono::month(static_cast<unsigned>(month)))};
  const auto days = static_cast<int>(static_cast<unsigned>(last.day()));
  if (day < 1 || day > days) {
    return refuse(problem, "must have a day from 01 to {} in {:04}-{:02}", days, year, month);
  }
  return kDay * days_since_1970({chrono::year(year), chrono::month(static_cast<unsigned>(month)),
                                 chrono::day(static_cast<unsigned>(day))});
}

std::optional<double> parse_time(std::string_view text, std::string* problem) {
  const bool with_seconds = text.size() == 8;
  const bool shape =
      (with_seconds && text[2] == ':' && text[5] == ':') || (text.size() == 5 && text[2] == ':');
  const int hour = shape ? digits(text, 0, 2) : -1;
  const int minute = shape ? digits(text, 3, 2) : -1;
  const int second = !shape ? -1 : with_seconds ? digits(text, 6, 2) : 0;
  if (hour < 0 || minute < 0 || second < 0) {
    return refuse(problem, "must be HH:MM or HH:MM:SS (UTC), as 18:30");
  }
  if (hour > 23 || minute > 59 || second > 59) {
    return refuse(problem, "must be a time from 00:00:00 to 23:59:59 (UTC)");
  }
  return hour * 3600.0 + minute * 60.0 + second;
}

std::string date_text(double utc_seconds) {
  const auto days = static_cast<int>(std::floor(utc_seconds / kDay));
  const chrono::year_month_day date{chrono::sys_days(chrono::days(days))};
  return fmt::format("{:04}-{:02}-{:02}", static_cast<int>(date.year()),
                     static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()));
}

std::string time_text(double utc_seconds) {
  const double in_day = utc_seconds - kDay * std::floor(utc_seconds / kDay);
  const int seconds = static_cast<int>(in_day);
  return fmt::format("{:02}:{:02}:{:02}", seconds / 3600, seconds / 60 % 60, seconds % 60);
}

}  // namespace offing
