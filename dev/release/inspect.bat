@echo off
rem Drop OpenSim models on this file: it shows their contacts and keeps the window open.
"%~dp0osim-contact-scale.exe" inspect %*
echo.
pause
