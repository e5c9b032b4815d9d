#include "tether_monitor/files/csv_writer.h"

#include <cmath>
#include <filesystem>
#include <stdexcept>

namespace tether_monitor::files
{
CsvWriter::CsvWriter(const std::string& path, const std::string& header)
  : path_(path), file_(std::fopen(path.c_str(), "w"))
{
  if (!file_)
    throw std::runtime_error("cannot write " + path);
  std::fprintf(file_.get(), "%s\n", header.c_str());
}

void CsvWriter::separate()
{
  if (row_has_fields_)
    std::fputc(',', file_.get());
  row_has_fields_ = true;
}

CsvWriter& CsvWriter::number(double value)
{
  separate();
  if (std::isnan(value))
    std::fputs("nan", file_.get());
  else
    std::fprintf(file_.get(), "%.10g", value);
  return *this;
}

CsvWriter& CsvWriter::time(double t)
{
  separate();
  std::fprintf(file_.get(), "%.15g", t);
  return *this;
}

CsvWriter& CsvWriter::text(const std::string& value)
{
  separate();
  std::fputs(value.c_str(), file_.get());
  return *this;
}

void CsvWriter::endRow()
{
  row_has_fields_ = false;
  if (std::fputc('\n', file_.get()) == EOF || std::ferror(file_.get()))
    throw std::runtime_error("cannot write " + path_ + " (is the disk full?)");
}

void CsvWriter::close()
{
  if (std::fflush(file_.get()) != 0)
    throw std::runtime_error("cannot write " + path_ + " (is the disk full?)");
}

void makeFolder(const std::string& path)
{
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error || !std::filesystem::is_directory(path))
    throw std::runtime_error("cannot make the folder " + path + (error ? ": " + error.message() : ""));
}

}  // namespace tether_monitor::files
